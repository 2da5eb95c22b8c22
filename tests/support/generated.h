// SPDX-License-Identifier: Apache-2.0
// Documents with a generated part: tests compare that part with what its source generates now.
#pragma once

#include <string>

namespace fulcrum::test {

/// The bytes of a file of the repository.
std::string text_of(const std::string& relative);

/// A table cell of Markdown.
std::string in_cell(const std::string& text);

/// docs/`document` holds `generated` between its marks <!-- generated: PART --> and <!-- end of PART -->.
/// With FULCRUM_WRITE_REFERENCES in the environment it is written instead; what is outside the marks is
/// written by hand and kept.
void expect_generated(const std::string& document, const std::string& part, const std::string& generated);

/// A file of the repository that is generated as a whole; written in the same way.
void expect_generated_file(const std::string& relative, const std::string& generated);

}  // namespace fulcrum::test
