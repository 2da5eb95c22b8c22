// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/json_document.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "sim_core/numerics/files.h"

namespace fulcrum {
namespace {

int line_of_byte(const std::string& text, std::size_t byte) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
    return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

// Line at which the nesting of brackets outside strings first exceeds `limit` (0: nowhere). Runs before the
// parser, so that hostile input cannot cause deep recursion.
int line_too_deep(const std::string& text, int limit) {
    int depth = 0;
    bool in_string = false, escaped = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (escaped) {
                escaped = false;
            } else if (c == '\\') {
                escaped = true;
            } else if (c == '"') {
                in_string = false;
            }
            continue;
        }
        if (c == '"') in_string = true;
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        if (depth > limit) return line_of_byte(text, i);
    }
    return 0;
}

std::string pointer_token(const std::string& key) {
    std::string token;
    for (const char c : key) {
        if (c == '~') {
            token += "~0";
        } else if (c == '/') {
            token += "~1";
        } else {
            token += c;
        }
    }
    return token;
}

// Walks text that the parser has already accepted and records the line of every value.
class LineIndex {
  public:
    LineIndex(const std::string& text, std::map<std::string, int>& lines) : text_(text), lines_(lines) {}

    void value(const std::string& pointer) {
        blanks();
        lines_[pointer] = line_;
        if (at() == '{') {
            object(pointer);
        } else if (at() == '[') {
            array(pointer);
        } else if (at() == '"') {
            string();
        } else {
            while (position_ < text_.size() && std::string(",]} \t\r\n").find(at()) == std::string::npos)
                ++position_;
        }
    }
    /// Pointer of the first key given twice, empty if none.
    const std::string& duplicate() const { return duplicate_; }

  private:
    char at() const { return position_ < text_.size() ? text_[position_] : '\0'; }
    void blanks() {
        // A byte order mark may precede the first value; the parser skips it too.
        while (position_ < text_.size() && (std::string(" \t\r\n").find(at()) != std::string::npos ||
                                            static_cast<unsigned char>(at()) >= 0x80U)) {
            if (at() == '\n') ++line_;
            ++position_;
        }
    }
    std::string string() {
        const std::size_t begin = position_++;
        while (position_ < text_.size() && at() != '"') position_ += at() == '\\' ? 2 : 1;
        ++position_;
        return text_.substr(begin, position_ - begin);
    }
    void object(const std::string& pointer) {
        std::set<std::string> keys;
        ++position_;
        for (;;) {
            blanks();
            if (at() == '}') break;
            const int key_line = line_;
            const std::string key = nlohmann::json::parse(string()).get<std::string>();
            const std::string child = pointer + "/" + pointer_token(key);
            blanks();
            ++position_;  // the colon
            value(child);
            if (!keys.insert(key).second && duplicate_.empty()) {
                duplicate_ = child;
                lines_[child] = key_line;
            }
            blanks();
            if (at() != ',') break;
            ++position_;
        }
        ++position_;
    }
    void array(const std::string& pointer) {
        ++position_;
        for (std::size_t index = 0;; ++index) {
            blanks();
            if (at() == ']') break;
            value(pointer + "/" + std::to_string(index));
            blanks();
            if (at() != ',') break;
            ++position_;
        }
        ++position_;
    }

    const std::string& text_;
    std::map<std::string, int>& lines_;
    std::size_t position_ = 0;
    int line_ = 1;
    std::string duplicate_;
};

// The parser's message without its own prefix and position, which are reported as a line.
std::string syntax_text(const std::string& what) {
    const std::size_t bracket = what.find("] ");
    std::string text = bracket == std::string::npos ? what : what.substr(bracket + 2);
    const std::size_t colon = text.find(": ");
    if (text.rfind("parse error", 0) == 0 && colon != std::string::npos) text = text.substr(colon + 2);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

std::string read_text_file(const std::string& path, std::size_t limit) {
    require_regular_file(path);
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "the file cannot be opened"),
                         QT_TRANSLATE_NOOP("errors", "check the path and the permission to read it"));
    // In blocks: most files are far smaller than what they may be, which is 1 GiB for a trace.
    std::string text;
    constexpr std::size_t block = std::size_t{1} << 16U;
    while (text.size() <= limit && stream) {
        const std::size_t begin = text.size();
        text.resize(std::min(begin + block, limit + 1));
        stream.read(text.data() + begin, static_cast<std::streamsize>(text.size() - begin));
        text.resize(begin + static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad() || (text.empty() && !stream.eof())) {
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "the file cannot be read"),
                         QT_TRANSLATE_NOOP("errors", "give a regular file, not a folder"));
    }
    if (text.size() > limit) {
        throw InputError(path, "", {QT_TRANSLATE_NOOP("errors", "the file is larger than %1 bytes"), limit},
                         QT_TRANSLATE_NOOP("errors", "split it or remove what it does not need"));
    }
    return text;
}

JsonDocument JsonDocument::parse(const std::string& text, const std::string& file, const JsonLimits& limits) {
    if (text.size() > limits.bytes) {
        throw InputError(file, "",
                         {QT_TRANSLATE_NOOP("errors", "the text is larger than %1 bytes"), limits.bytes},
                         QT_TRANSLATE_NOOP("errors", "remove what it does not need"));
    }
    if (const int line = line_too_deep(text, limits.depth); line > 0) {
        throw InputError(
            file, std::to_string(line),
            {QT_TRANSLATE_NOOP("errors", "the text is nested deeper than %1 levels"), limits.depth},
            QT_TRANSLATE_NOOP("errors", "check for a bracket that is never closed"));
    }
    JsonDocument document;
    document.file_ = file;
    try {
        document.root_ = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        throw InputError(
            file, std::to_string(line_of_byte(text, error.byte > 0 ? error.byte - 1 : 0)),
            {QT_TRANSLATE_NOOP("errors", "the text is not valid JSON: %1"), syntax_text(error.what())},
            QT_TRANSLATE_NOOP("errors", "correct the text at this line or just before it"));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(
            file, "1",
            {QT_TRANSLATE_NOOP("errors", "the text is not valid JSON: %1"), syntax_text(error.what())},
            QT_TRANSLATE_NOOP("errors", "use numbers between -1e308 and 1e308"));
    }
    LineIndex index(text, document.lines_);
    index.value("");
    if (!index.duplicate().empty())
        document.fail(index.duplicate(), QT_TRANSLATE_NOOP("errors", "the key is given twice"),
                      QT_TRANSLATE_NOOP("errors", "remove one of the two"));
    return document;
}

JsonDocument JsonDocument::load(const std::string& path, const JsonLimits& limits) {
    return parse(read_text_file(path, limits.bytes), path, limits);
}

int JsonDocument::line(const std::string& pointer) const {
    std::string place = pointer;
    for (;;) {
        const auto found = lines_.find(place);
        if (found != lines_.end()) return found->second;
        if (place.empty()) return 1;
        place.resize(place.rfind('/'));
    }
}

void JsonDocument::fail(const std::string& pointer, const Sentence& wrong, const Sentence& hint) const {
    throw InputError(file_, std::to_string(line(pointer)) + (pointer.empty() ? "" : " (" + pointer + ")"),
                     wrong, hint);
}

}  // namespace fulcrum
