# SPDX-License-Identifier: Apache-2.0
fulcrum_room(sim_core/world/parts/sheet USES sim_core/numerics sim_core/geometry sim_core/cutting sim_core/membrane sim_core/scene sim_core/anatomy sim_core/instrument sim_core/contact sim_core/world/part
    APART fibre_parting.cpp sheet_blades.cpp sheet_contact.cpp)
