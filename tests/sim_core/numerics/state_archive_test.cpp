// SPDX-License-Identifier: Apache-2.0
// State as bytes: every bit comes back whatever of a table is used, what was never used costs nothing, and
// damaged bytes are refused without taking the memory that they ask for.
#include "sim_core/numerics/state_archive.h"

#include <gtest/gtest.h>

#include <random>

namespace fulcrum {
namespace {

struct Row {
    double value = -1;
    std::int32_t number = -1;
    std::array<std::uint8_t, 3> letters{};
    bool operator==(const Row& other) const {
        return value == other.value && number == other.number && letters == other.letters;
    }
};

struct Tables {
    std::vector<Row> rows;
    std::vector<std::uint8_t> flags;
    std::vector<double> numbers;
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(rows, flags, numbers);
    }
};

std::vector<std::uint8_t> bytes_of(Tables& tables, std::vector<std::uint32_t>* starts = nullptr) {
    std::vector<std::uint8_t> bytes;
    StateArchive archive(bytes, starts);
    archive(tables);
    archive.finish();
    return bytes;
}

void read(Tables& tables, const std::vector<std::uint8_t>& bytes) {
    StateArchive archive(bytes.data(), bytes.size());
    archive(tables);
    archive.finish();
}

Tables with(std::size_t used, std::size_t size, std::uint32_t seed) {
    std::mt19937 random(seed);
    Tables tables;
    tables.rows.resize(size);
    tables.flags.resize(size);
    tables.numbers.resize(size, 0.5);
    for (std::size_t i = 0; i < used; ++i) {
        tables.rows[i].number = static_cast<std::int32_t>(random());
        tables.flags[i] = static_cast<std::uint8_t>(random());
        tables.numbers[i] = static_cast<double>(random());
    }
    return tables;
}

TEST(StateArchive, EveryEntryComesBackWhateverIsUsed) {
    const std::pair<std::size_t, std::size_t> shapes[] = {{0, 0},   {0, 1},     {1, 1},       {0, 2},
                                                          {1, 2},   {2, 2},     {3, 5000},    {4999, 5000},
                                                          {17, 64}, {256, 257}, {5000, 5000}, {0, 5000}};
    Tables reader = with(100, 300, 7);
    for (const auto& [used, size] : shapes) {
        Tables written = with(used, size, 1);
        read(reader, bytes_of(written));
        EXPECT_EQ(reader.rows, written.rows) << used << " of " << size;
        EXPECT_EQ(reader.flags, written.flags) << used << " of " << size;
        EXPECT_EQ(reader.numbers, written.numbers) << used << " of " << size;
    }
}

TEST(StateArchive, OfTheSameTablesMoreOrLessUsedOneAfterTheOther) {
    Tables reader = with(4000, 5000, 3);
    std::mt19937 random(5);
    for (int i = 0; i < 40; ++i) {
        Tables written = with(random() % 5001, 5000, static_cast<std::uint32_t>(i));
        if (i % 3 == 0) written.numbers.assign(5000, 0.25);  // another end
        read(reader, bytes_of(written));
        ASSERT_EQ(reader.rows, written.rows) << i;
        ASSERT_EQ(reader.numbers, written.numbers) << i;
    }
}

TEST(StateArchive, WhatWasNeverUsedTakesNoBytes) {
    Tables few = with(10, 100'000, 1), small = with(10, 11, 1);
    EXPECT_EQ(bytes_of(few).size(), bytes_of(small).size());
    std::vector<std::uint32_t> starts;
    const std::vector<std::uint8_t> bytes = bytes_of(few, &starts);
    ASSERT_EQ(starts.size(), 3U);
    EXPECT_EQ(starts[1] - starts[0], 11 * sizeof(Row) + 2 * sizeof(std::uint64_t))
        << "the entries, then the two counts of the next table";
    EXPECT_LT(starts[2], bytes.size());
}

TEST(StateArchive, DamagedBytesAreRefused) {
    Tables written = with(10, 1000, 1), reader = written;
    const std::vector<std::uint8_t> good = bytes_of(written);
    for (std::size_t cut = 0; cut < good.size(); ++cut)
        EXPECT_THROW(read(reader, {good.begin(), good.begin() + static_cast<std::ptrdiff_t>(cut)}),
                     StateArchiveError)
            << cut;
    const auto with_number = [&](std::size_t place, std::uint64_t number) {
        std::vector<std::uint8_t> bytes = good;
        std::memcpy(bytes.data() + place, &number, sizeof number);
        return bytes;
    };
    const std::uint64_t huge = std::uint64_t{1} << 60U;
    EXPECT_THROW(read(reader, with_number(0, huge)), StateArchiveError) << "entries";
    EXPECT_THROW(read(reader, with_number(8, huge)), StateArchiveError) << "entries in use";
    EXPECT_THROW(read(reader, with_number(8, 0)), StateArchiveError) << "none in use of many";
    EXPECT_THROW(read(reader, with_number(0, 3)), StateArchiveError) << "fewer than in use";
    read(reader, good);
    EXPECT_EQ(reader.rows, written.rows);
}

}  // namespace
}  // namespace fulcrum
