// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of the curriculum that their authors have not saved or published, by person, while nobody shows
// them: after a sign-out, and while the pages are made again. They last as long as the window.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "ui/dashboards/curriculum_page.h"

namespace fulcrum::ui {

class KeptDrafts {
  public:
    /// Null: the page was not made.
    void keep(const CurriculumPage* page) {
        if (page == nullptr) return;
        if (auto begun = page->begun()) drafts_.insert_or_assign(begun->author, *begun);
    }
    /// The draft of the person who is signed in; it is no longer kept here.
    std::optional<CurriculumPage::Begun> take(const database::Session& session) {
        const auto found = drafts_.find(session.person_id());
        if (found == drafts_.end() || session.must_change_password()) return std::nullopt;
        std::optional<CurriculumPage::Begun> draft = std::move(found->second);
        drafts_.erase(found);
        return draft;
    }
    /// One that ends with the window: no file has it.
    bool has_unsaved() const {
        return std::any_of(drafts_.begin(), drafts_.end(), [](const auto& one) { return !one.second.saved; });
    }

  private:
    std::map<std::string, CurriculumPage::Begun> drafts_;
};

}  // namespace fulcrum::ui
