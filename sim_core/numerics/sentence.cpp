// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

std::string in_english(const char* /*context*/, const char* source) {
    return source;
}

std::string Sentence::words(Translate translate) const {
    const std::string text = marked_ ? translate(context, source_.c_str()) : source_;
    if (parts_.empty()) return text;
    // In one pass: what a part says is not searched for places.
    std::string words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool digit = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9';
        const std::size_t part = digit ? static_cast<std::size_t>(text[i + 1] - '1') : parts_.size();
        if (part < parts_.size()) {
            words += parts_[part].words(translate);
            ++i;
        } else {
            words += text[i];
        }
    }
    return words;
}

std::vector<std::string> english_of(const std::vector<Sentence>& sentences) {
    std::vector<std::string> words;
    for (const Sentence& sentence : sentences) words.push_back(sentence.words());
    return words;
}

Sentence Sentence::from_parts(std::string source, bool marked, std::vector<Sentence> parts) {
    Sentence made;
    made.source_ = std::move(source);
    made.marked_ = marked;
    made.parts_ = std::move(parts);
    return made;
}

}  // namespace fulcrum
