// SPDX-License-Identifier: GPL-3.0-or-later
// Ann's standing at one task, as her educator reads it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "database/records/standings.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {

inline TaskStanding standing_of_ann(const Programme& programme, const Curriculum& curriculum,
                                    const std::string& task, std::int64_t at) {
    const PersonRecord record =
        Standings(*programme.store).record(programme.session("educator"), programme.id("ann"), curriculum);
    for (const TaskStanding& one : standing_of(record, at))
        if (one.task == task) return one;
    ADD_FAILURE() << task;
    return {};
}

}  // namespace fulcrum::database::test
