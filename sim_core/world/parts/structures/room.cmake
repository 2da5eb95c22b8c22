# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/structures USES sim_core/numerics sim_core/geometry sim_core/scene sim_core/anatomy sim_core/instrument sim_core/contact sim_core/world/part sim_core/world/field
    APART structures_layout.cpp)
