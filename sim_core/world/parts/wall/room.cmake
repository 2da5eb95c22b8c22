# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/wall USES sim_core/anatomy sim_core/world/part)
