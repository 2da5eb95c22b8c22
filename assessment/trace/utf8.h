// SPDX-License-Identifier: Apache-2.0
// Text that comes from outside and goes into JSON must be UTF-8.
#pragma once

#include <string_view>

namespace fulcrum {

/// Well-formed UTF-8 without control characters (RFC 3629: no overlong forms, no surrogates).
bool is_utf8(std::string_view text);

}  // namespace fulcrum
