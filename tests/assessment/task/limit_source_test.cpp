// SPDX-License-Identifier: Apache-2.0
// The line that says where a limit comes from is read as it was written; a line of another form is words.
#include "assessment/task/limit_source.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace fulcrum {
namespace {

TEST(LimitSources, AreReadAsTheyWereWritten) {
    using Kind = LimitSource::Kind;
    for (const char* of :
         {"synthetic operators, seeds 1000-1999", "experts of this site", "Leeds, set 3", ""})
        for (const bool worst : {false, true}) {
            LimitSource written;
            written.kind = Kind::range;
            written.of = of;
            written.set = 12;
            written.experts = 32;
            written.worst_counted = worst;
            const LimitSource read = read_limit_source(limit_source_line(written));
            EXPECT_EQ(read.kind, Kind::range) << of;
            EXPECT_EQ(read.of, of);
            EXPECT_EQ(read.set, 12);
            EXPECT_EQ(read.experts, 32);
            EXPECT_EQ(read.worst_counted, worst);
            EXPECT_EQ(read.is_simulated(), std::string(of).rfind("synthetic", 0) == 0);
        }
    LimitSource taken;
    taken.kind = Kind::taken_over;
    taken.of = "Training limit, taken over by hand";
    taken.site = "experts of this site";
    taken.set = 4;
    const LimitSource read = read_limit_source(limit_source_line(taken));
    EXPECT_EQ(read.kind, Kind::taken_over);
    EXPECT_EQ(read.of, taken.of);
    EXPECT_EQ(read.site, taken.site);
    EXPECT_EQ(read.set, 4);
}

TEST(LimitSources, OfAnotherFormAreWords) {
    for (const std::string& line :
         std::vector<std::string>{"", "A margin of 1 mm or less is positive", "32 experts",
                                  ", set , 3 experts", "set 4", "x, set 4", "x, set 99999999999, 3 experts",
                                  "x, set 4, 3 experts, worst", "x, taken over by y, set "}) {
        const LimitSource read = read_limit_source(line);
        EXPECT_EQ(read.kind, LimitSource::Kind::words) << line;
        EXPECT_EQ(read.of, line);
        EXPECT_EQ(limit_source_line(read), line);
    }
}

}  // namespace
}  // namespace fulcrum
