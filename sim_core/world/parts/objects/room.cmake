# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/objects USES sim_core/numerics sim_core/geometry sim_core/scene sim_core/rigid sim_core/world/part)
