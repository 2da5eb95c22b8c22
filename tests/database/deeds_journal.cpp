// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/deeds_journal.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "tests/database/processes.h"

namespace fulcrum::database::test {
namespace {

template <std::size_t size>
void put(char (&to)[size], const std::string& text) {
    const std::size_t length = std::min(size - 1, text.size());
    std::memcpy(to, text.data(), length);
    to[length] = 0;
}

}  // namespace

DeedsJournal& DeedsJournal::in(const std::string& folder) {
    const int file = ::open((folder + "/deeds").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    void* memory = MAP_FAILED;
    if (file >= 0 && ::ftruncate(file, sizeof(DeedsJournal)) == 0)
        memory = ::mmap(nullptr, sizeof(DeedsJournal), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED) std::abort();
    ::close(file);
    return *static_cast<DeedsJournal*>(memory);
}

void DeedsJournal::clear() {
    ready = begun = acknowledged = count_ = 0;
}

void DeedsJournal::acknowledge(DeedKind kind, const std::string& object, std::uint32_t number,
                               const std::string& other) {
    enter(kind, object, number, other);
    acknowledged.fetch_add(1);
}

void DeedsJournal::enter(DeedKind kind, const std::string& object, std::uint32_t number,
                         const std::string& other) {
    const std::uint32_t at = count_.load();
    if (at >= room) std::abort();
    deeds_[at].kind = kind;
    deeds_[at].number = number;
    put(deeds_[at].object, object);
    put(deeds_[at].other, other);
    count_.store(at + 1);
}

std::vector<Deed> DeedsJournal::deeds() const {
    return {deeds_, deeds_ + count_.load()};
}

bool wait_for_deeds(const DeedsJournal& journal, pid_t child, std::uint32_t count) {
    while (journal.ready.load() == 0 || journal.acknowledged.load() < count) {
        if (!is_running(child)) return false;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return true;
}

int kills_asked(int usually) {
    const char* asked = std::getenv("FULCRUM_KILLS");
    return asked != nullptr ? std::atoi(asked) : usually;
}

}  // namespace fulcrum::database::test
