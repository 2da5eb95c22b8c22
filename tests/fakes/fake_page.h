// SPDX-License-Identifier: Apache-2.0
// A page of memory that a test shares with a fake of a maker's library in the device process.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>

#include "sim_core/devices/device_page.h"
#include "tests/support/own_folder.h"

namespace fulcrum::test {

/// `variable` names the file of the page to the library.
template <typename Page>
class FakePage {
  public:
    explicit FakePage(const char* variable) : variable_(variable) {
        const std::string path = (folder_ / "page").string();
        const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (file < 0 || ftruncate(file, sizeof(Page)) != 0) throw std::runtime_error(path);
        void* const memory = mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
        if (memory == MAP_FAILED) throw std::runtime_error(path);
        page_ = new (memory) Page;
        setenv(variable, path.c_str(), 1);
    }
    ~FakePage() {
        unsetenv(variable_);
        munmap(static_cast<void*>(page_), sizeof(Page));
    }
    FakePage(const FakePage&) = delete;
    FakePage& operator=(const FakePage&) = delete;
    Page* operator->() const { return page_; }

  private:
    const char* variable_;
    OwnFolder folder_;
    Page* page_ = nullptr;
};

/// Sets a variable of the environment while it exists.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
    ~Variable() { unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
};

/// Waits at most 8 s.
template <typename Condition>
bool until(Condition&& holds) {
    const std::int64_t last = monotonic_ns() + 8'000'000'000;
    while (!holds()) {
        if (monotonic_ns() > last) return false;
        usleep(500);
    }
    return true;
}

/// Whether a DaemonClient says these words before long: a fault is written apart from what is present.
template <typename Client>
bool says(Client& client, const std::string& words) {
    return until([&] {
        client.poll();
        return client.message().words() == words;
    });
}

}  // namespace fulcrum::test
