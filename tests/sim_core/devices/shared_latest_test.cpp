// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/shared_latest.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <thread>

#include "sim_core/devices/device_page.h"

namespace fulcrum {
namespace {

struct Wide {
    std::uint64_t words[16] = {};
};

TEST(SharedLatest, AReaderNeverSeesHalfOfAValue) {
    SharedLatest<Wide> shared;
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        for (std::uint64_t i = 1; !stop.load(); ++i) {
            Wide value;
            for (auto& word : value.words) word = i;
            shared.write(value);
        }
    });
    Wide value;
    std::uint64_t newest = 0, reads = 0;
    while (reads < 200000) {
        if (!shared.read(value)) continue;
        ++reads;
        for (const auto word : value.words) ASSERT_EQ(word, value.words[0]);
        ASSERT_GE(value.words[0], newest);
        newest = value.words[0];
    }
    stop.store(true);
    writer.join();
}

TEST(SharedLatest, BeforeTheFirstWriteThereIsNothing) {
    SharedLatest<Wide> shared;
    Wide value;
    value.words[3] = 7;
    EXPECT_FALSE(shared.read(value));
    EXPECT_EQ(value.words[3], 7U);
}

TEST(SharedLatest, AWriterThatDiedInTheMiddleDoesNotHoldUpTheReader) {
    SharedLatest<Wide> shared;
    shared.write({});
    // As after a kill between the two stores of the version: the first word of the object is odd.
    reinterpret_cast<std::atomic<std::uint64_t>*>(&shared)->store(3);
    Wide value;
    EXPECT_FALSE(shared.read(value));
    shared.write({});  // the next writer repairs it
    EXPECT_TRUE(shared.read(value));
}

TEST(SharedPage, TheOtherSideCanOnlyReadTheState) {
    auto own = SharedPage<StatePage>::create("test", true);
    const int other = dup(own.descriptor());
    EXPECT_EQ(mmap(nullptr, sizeof(StatePage), PROT_READ | PROT_WRITE, MAP_SHARED, other, 0), MAP_FAILED);
    EXPECT_NE(ftruncate(other, 0), 0) << "a page that shrinks would end its readers";
    auto view = SharedPage<StatePage>::open(other, false);
    DevicePose pose;
    EXPECT_FALSE(view->pose[1].read(pose));
    pose.sequence = 5;
    own->pose[1].write(pose);
    EXPECT_TRUE(view->pose[1].read(pose));
    EXPECT_EQ(pose.sequence, 5U);
}

TEST(SharedPage, RefusesAnotherSizeAndMemoryWithoutSeals) {
    auto command = SharedPage<CommandPage>::create("test", false);
    EXPECT_THROW(SharedPage<StatePage>::open(dup(command.descriptor()), false), std::runtime_error);
    const int plain = memfd_create("plain", MFD_ALLOW_SEALING);
    ASSERT_EQ(ftruncate(plain, sizeof(CommandPage)), 0);
    EXPECT_THROW(SharedPage<CommandPage>::open(plain, true), std::runtime_error);
}

}  // namespace
}  // namespace fulcrum
