# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/bowel USES sim_core/numerics sim_core/geometry sim_core/bowel sim_core/rod sim_core/scene sim_core/anatomy sim_core/collision sim_core/instrument sim_core/contact sim_core/world/part)
