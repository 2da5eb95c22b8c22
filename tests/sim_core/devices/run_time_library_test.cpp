// SPDX-License-Identifier: Apache-2.0
// A library that is not there is missing, whatever the language of the system's messages.
#include "sim_core/devices/run_time_library.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <libintl.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "tests/support/german_locale.h"

namespace fulcrum {
namespace {

/// A catalogue of messages with one of them, in the form of GNU gettext.
void write_catalogue(const std::string& path, const std::string& message, const std::string& translation) {
    constexpr std::uint32_t texts = 44;
    const auto size = static_cast<std::uint32_t>(message.size()),
               translated = static_cast<std::uint32_t>(translation.size());
    const std::uint32_t words[] = {0x950412de,      0, 1, 28, 36, 0, texts, size, texts, translated,
                                   texts + size + 1};
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(words), sizeof words);
    file.write(message.c_str(), size + 1);
    file.write(translation.c_str(), translated + 1);
}

TEST(RunTimeLibrary, IsMissingInEveryLanguageOfTheSystem) {
    const test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    const std::string folder = german.folder() + "/de/LC_MESSAGES", name = "libfulcrum-none.so";
    std::filesystem::create_directories(folder);
    write_catalogue(folder + "/libc.mo", "cannot open shared object file", "Datei fehlt");
    const std::string before = bindtextdomain("libc", nullptr);
    bindtextdomain("libc", german.folder().c_str());
    EXPECT_EQ(dlopen(name.c_str(), RTLD_NOW), nullptr);
    const std::string said = dlerror();
    const LibraryLook look = load_run_time_library("NO_LIBRARY_IS_NAMED_HERE", {name}, {});
    bindtextdomain("libc", before.c_str());
    EXPECT_EQ(look.state, LibraryState::missing) << look.detail;
    if (said.find("Datei fehlt") == std::string::npos)
        GTEST_SKIP() << "this system has messages in English only: " << said;
}

}  // namespace
}  // namespace fulcrum
