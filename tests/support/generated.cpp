// SPDX-License-Identifier: Apache-2.0
#include "tests/support/generated.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/support/support.h"

namespace fulcrum::test {

std::string text_of(const std::string& relative) {
    std::ifstream file(source_path(relative), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string in_cell(const std::string& text) {
    std::string cell;
    for (const char c : text) {
        if (c == '|') cell += '\\';
        cell += c;
    }
    return cell;
}

void expect_generated(const std::string& document, const std::string& part, const std::string& generated) {
    const std::string begin_mark = "<!-- generated: " + part + " -->\n",
                      end_mark = "<!-- end of " + part + " -->\n";
    std::string text = text_of("docs/" + document);
    const std::size_t begin = text.find(begin_mark), end = text.find(end_mark);
    ASSERT_NE(begin, std::string::npos) << document << " has no mark where the generated part begins";
    ASSERT_NE(end, std::string::npos) << document << " has no mark where the generated part ends";
    const std::size_t from = begin + begin_mark.size();
    if (std::getenv("FULCRUM_WRITE_REFERENCES") != nullptr) {
        text.replace(from, end - from, generated);
        std::ofstream(source_path("docs/" + document), std::ios::binary | std::ios::trunc) << text;
        return;
    }
    EXPECT_TRUE(text.substr(from, end - from) == generated)
        << "docs/" << document
        << " differs from what its source generates; run this test with FULCRUM_WRITE_REFERENCES=1";
}

void expect_generated_file(const std::string& relative, const std::string& generated) {
    if (std::getenv("FULCRUM_WRITE_REFERENCES") != nullptr) {
        std::ofstream(source_path(relative), std::ios::binary | std::ios::trunc) << generated;
        return;
    }
    EXPECT_TRUE(text_of(relative) == generated)
        << relative
        << " differs from what its source generates; run this test with FULCRUM_WRITE_REFERENCES=1";
}

}  // namespace fulcrum::test
