// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/utf8.h"

#include <cstdint>

namespace fulcrum {

bool is_utf8(std::string_view text) {
    std::size_t i = 0;
    while (i < text.size()) {
        const auto lead = static_cast<unsigned char>(text[i]);
        if (lead < 0x80) {
            if (lead < 0x20 || lead == 0x7F) return false;
            ++i;
            continue;
        }
        int more = 0;
        std::uint32_t code = 0, least = 0;
        if ((lead & 0xE0U) == 0xC0U) {
            more = 1, code = lead & 0x1FU, least = 0x80;
        } else if ((lead & 0xF0U) == 0xE0U) {
            more = 2, code = lead & 0x0FU, least = 0x800;
        } else if ((lead & 0xF8U) == 0xF0U) {
            more = 3, code = lead & 0x07U, least = 0x10000;
        } else {
            return false;
        }
        for (int k = 1; k <= more; ++k) {
            if (i + static_cast<std::size_t>(k) >= text.size()) return false;
            const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
            if ((next & 0xC0U) != 0x80U) return false;
            code = (code << 6U) | (next & 0x3FU);
        }
        if (code < least || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return false;
        i += static_cast<std::size_t>(more) + 1;
    }
    return true;
}

}  // namespace fulcrum
