# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/targets USES sim_core/numerics sim_core/rigid sim_core/world/part)
