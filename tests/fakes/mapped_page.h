// SPDX-License-Identifier: Apache-2.0
// The fake's side of a page that a test made (fake_page.h).
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace fulcrum::test {

/// Maps the page that an environment variable names. Without one, a page that nobody looks at.
template <class Page>
class MappedPage {
  public:
    explicit MappedPage(const char* variable) : variable_(variable) {}
    /// Another test of the same process has another page: called where a device is opened.
    void map() {
        const char* const named = std::getenv(variable_);
        const std::string path = named != nullptr ? named : "";
        if (page_ != nullptr && path == mapped_from_) return;
        mapped_from_ = path;
        page_ = nullptr;
        const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
        if (file >= 0) {
            void* const memory = mmap(nullptr, sizeof(Page), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
            close(file);
            if (memory != MAP_FAILED) page_ = static_cast<Page*>(memory);
        }
        if (page_ == nullptr) page_ = new Page;
    }
    Page* get() {
        if (page_ == nullptr) map();
        return page_;
    }

  private:
    const char* variable_;
    Page* page_ = nullptr;
    std::string mapped_from_;
};

}  // namespace fulcrum::test
