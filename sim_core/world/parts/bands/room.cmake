# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/bands USES sim_core/numerics sim_core/geometry sim_core/scene sim_core/instrument sim_core/contact sim_core/strand sim_core/world/part sim_core/world/field)
