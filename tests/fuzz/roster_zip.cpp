// SPDX-License-Identifier: GPL-3.0-or-later
// For any bytes read as an archive of tables of people: either an InputError with file and hint, or files of
// the names that were asked for, none larger than it may be.
#include <algorithm>
#include <cstdlib>

#include "database/roster/zip_entries.h"
#include "sim_core/numerics/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum;
    static const std::vector<std::string> names = {"users.csv", "roles.csv", "classes.csv",
                                                   "enrollments.csv"};
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        for (const auto& [name, content] : database::parse_zip(bytes, "fuzz.zip", names)) {
            if (std::find(names.begin(), names.end(), name) == names.end()) std::abort();
            if (content.size() > database::largest_zip_entry) std::abort();
        }
    } catch (const InputError& error) {
        if (error.file().empty() || error.hint().empty()) std::abort();
    }
    return 0;
}
