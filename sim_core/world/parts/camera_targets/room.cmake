# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/camera_targets USES sim_core/numerics sim_core/geometry sim_core/scene sim_core/instrument sim_core/world/part)
