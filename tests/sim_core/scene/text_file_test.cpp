// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

class TextFile : public ::testing::Test {
  protected:
    std::string written(std::size_t size) const {
        std::string text(size, 'a');
        for (std::size_t k = 0; k < size; k += 4099) text[k] = '\n';
        std::ofstream(path_, std::ios::binary) << text;
        return text;
    }
    test::OwnFolder folder_;
    std::string path_ = (folder_ / "text").string();
};

TEST_F(TextFile, IsReadWholeUpToItsLimit) {
    for (const std::size_t size : {0U, 1U, 65535U, 65536U, 65537U, 131072U, 1000003U}) {
        const std::string text = written(size);
        EXPECT_EQ(read_text_file(path_, size), text) << size;
        EXPECT_EQ(read_text_file(path_, size + 1), text) << size;
        EXPECT_EQ(read_text_file(path_, 5000000), text) << size;
        if (size > 0) {
            EXPECT_THROW(read_text_file(path_, size - 1), InputError) << size;
        }
    }
}

TEST_F(TextFile, TakesMemoryForWhatItHoldsAndNotForItsLimit) {
    written(1000);
    EXPECT_LT(read_text_file(path_, std::size_t{1} << 30U).capacity(), std::size_t{1} << 20U);
}

}  // namespace
}  // namespace fulcrum
