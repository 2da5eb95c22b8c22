// SPDX-License-Identifier: GPL-3.0-or-later
// People as a ZIP archive: read as the folder is, and refused where it is damaged, cut off, locked or too
// large.
#include "database/roster/zip_entries.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>

#include "database/roster/roster.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum::database {
namespace {

struct Packed {
    std::string name, content;
    bool deflate = true;
    std::uint16_t flags = 0, method = 0;  ///< method: 0, as `deflate` says
    std::uint32_t claimed = 0;            ///< size that the archive states; 0: the true one
};

std::string zip_number(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 0xffU);
    return text;
}

std::string zip_deflated(const std::string& content) {
    z_stream stream = {};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, content.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string zip_of(const std::vector<Packed>& files, const std::string& comment = {}) {
    std::string archive, directory;
    for (const Packed& file : files) {
        const std::string data = file.deflate ? zip_deflated(file.content) : file.content;
        const std::uint16_t method = file.method != 0 ? file.method : file.deflate ? 8 : 0;
        const auto crc = static_cast<std::uint32_t>(crc32(
            0, reinterpret_cast<const Bytef*>(file.content.data()), static_cast<uInt>(file.content.size())));
        const auto size = file.claimed != 0 ? file.claimed : static_cast<std::uint32_t>(file.content.size());
        const std::string same =
            zip_number(20, 2) + zip_number(file.flags, 2) + zip_number(method, 2) + zip_number(0, 4) +
            zip_number(crc, 4) + zip_number(static_cast<std::uint32_t>(data.size()), 4) +
            zip_number(size, 4) + zip_number(static_cast<std::uint32_t>(file.name.size()), 2) +
            zip_number(0, 2);
        directory += zip_number(0x02014b50, 4) + zip_number(20, 2) + same + zip_number(0, 2) +
                     zip_number(0, 2) + zip_number(0, 2) + zip_number(0, 4) +
                     zip_number(static_cast<std::uint32_t>(archive.size()), 4) + file.name;
        archive += zip_number(0x04034b50, 4) + same + file.name + data;
    }
    const auto count = static_cast<std::uint32_t>(files.size());
    return archive + directory + zip_number(0x06054b50, 4) + zip_number(0, 4) + zip_number(count, 2) +
           zip_number(count, 2) + zip_number(static_cast<std::uint32_t>(directory.size()), 4) +
           zip_number(static_cast<std::uint32_t>(archive.size()), 4) +
           zip_number(static_cast<std::uint32_t>(comment.size()), 2) + comment;
}

const std::vector<Packed> packed_school = {
    {"manifest.csv", "propertyName,value\n"},
    {"users.csv", "sourcedId,username,givenName,familyName,role\nu1,mia,Mia,Berg,student\n"},
    {"classes.csv", "sourcedId,title\nc1,Year 2\n", false},
    {"enrollments.csv", "sourcedId,classSourcedId,userSourcedId,role\ne1,c1,u1,student\n"}};
const std::vector<std::string> asked_for = {"users.csv", "roles.csv", "classes.csv", "enrollments.csv"};

std::string zip_refusal(const std::string& bytes) {
    try {
        parse_zip(bytes, "school.zip", asked_for);
        return {};
    } catch (const InputError& error) {
        EXPECT_FALSE(error.hint().empty());
        EXPECT_EQ(error.file(), "school.zip");
        return error.problem();
    }
}
std::string refusal_of(Packed file) {
    return zip_refusal(zip_of({std::move(file)}));
}

TEST(ZipEntries, AnArchiveIsReadAsTheFolderIs) {
    const fulcrum::test::OwnFolder folder;
    const auto write = [&](const char* name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return (folder / name).string();
    };
    std::vector<Packed> in_folder = packed_school;
    for (Packed& file : in_folder) file.name = "school/" + file.name;
    for (const std::string& bytes :
         {zip_of(packed_school), zip_of(packed_school, "a comment PK\5\6"), zip_of(in_folder)}) {
        const Roster roster = read_roster(write("school.zip", bytes));
        ASSERT_EQ(roster.people.size(), 1U);
        EXPECT_EQ(roster.people[0].login, "mia");
        EXPECT_EQ(roster.people[0].place, "users.csv:2");
        ASSERT_EQ(roster.cohorts.size(), 1U);
        EXPECT_EQ(roster.cohorts[0].name, "Year 2");
        EXPECT_EQ(roster.cohorts[0].members, std::vector<std::string>{"mia"});
    }
    EXPECT_TRUE(is_zip(write("none.zip", zip_of({}))));
    EXPECT_THROW(read_roster((folder / "none.zip").string()), InputError) << "has no users.csv";
    EXPECT_FALSE(is_zip(write("list.csv", "login,name\nmia,Mia Berg\n")));
    EXPECT_EQ(read_roster((folder / "list.csv").string()).people.size(), 1U);
    EXPECT_FALSE(is_zip((folder / "nowhere").string()));
}

TEST(ZipEntries, NamesElsewhereAreNotReadAndNoneTwice) {
    for (const char* name : {"../users.csv", "a/b/users.csv", "/users.csv", "//users.csv", "users.csv/",
                             "USERS.CSV", "users.csv.exe", "a\\users.csv"}) {
        EXPECT_TRUE(parse_zip(zip_of({{name, "x"}}), "school.zip", asked_for).empty()) << name;
    }
    EXPECT_EQ(zip_refusal(zip_of({{"users.csv", "x"}, {"users.csv", "y"}})), "is in the archive twice");
    EXPECT_EQ(zip_refusal(zip_of({{"users.csv", "x"}, {"a/roles.csv", "y"}})), "is in the archive twice");
    std::vector<Packed> many(most_zip_entries + 1, Packed{"x", "", false});
    EXPECT_EQ(zip_refusal(zip_of(many)), "the archive has 1001 files");
}

TEST(ZipEntries, LockedLargeOrDamagedArchivesAreRefused) {
    EXPECT_EQ(refusal_of({"users.csv", "x"}), "");
    EXPECT_EQ(refusal_of({"users.csv", "x", true, 1}), "is encrypted");
    EXPECT_EQ(refusal_of({"users.csv", "x", true, 0, 14}), "is packed by another method (14)");
    EXPECT_EQ(refusal_of({"users.csv", "x", true, 0, 0, largest_zip_entry + 1}), "is larger than 16 MiB");
    EXPECT_EQ(refusal_of({"users.csv", "x", true, 0, 0, 0xffffffff}), "is larger than 16 MiB");
    const std::string broken = "the archive is damaged or cut off";
    EXPECT_EQ(refusal_of({"users.csv", std::string(1U << 20U, '0'), true, 0, 0, 100}), broken)
        << "unpacks to more than it says";
    EXPECT_EQ(refusal_of({"users.csv", "xy", false, 0, 0, 1}), broken);
    EXPECT_EQ(refusal_of({"users.csv", "xy", false, 0, 8}), broken) << "not deflated, though it says so";
    const std::string good = zip_of(packed_school);
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_EQ(zip_refusal(good.substr(0, size)), broken) << "cut off after " << size;
    for (std::size_t at = 0; at < good.size(); ++at) {
        std::string changed = good;
        changed[at] = static_cast<char>(changed[at] ^ 0x41);
        zip_refusal(changed);  // refused, or a byte that is not looked at; never read beyond the end
    }
    std::string content = good;
    content[content.find("Year 2")] = 'y';
    EXPECT_EQ(zip_refusal(content), broken) << "the checksum";
}

}  // namespace
}  // namespace fulcrum::database
