# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/membranes USES sim_core/numerics sim_core/geometry sim_core/membrane sim_core/scene sim_core/anatomy sim_core/contact sim_core/world/part)
