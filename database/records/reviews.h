// SPDX-License-Identifier: GPL-3.0-or-later
// Comments at a moment of an attempt: drafts of their author until sent, unread until the trainee has seen
// them.
#pragma once

#include <string>
#include <vector>

#include "database/rows/attempt_records.h"
#include "database/store/store.h"

namespace fulcrum::database {

class Reviews {
  public:
    explicit Reviews(const Store& store) : store_(store) {}

    /// Sent comments, and the session's own drafts, by moment.
    std::vector<Comment> comments(const Session& session, const std::string& attempt_id) const;
    /// Writes a draft or sends at once. 1 to 4,000 characters. Returns the id.
    std::string write(const Session& educator, const std::string& attempt_id, double time_s,
                      const std::string& text, bool send) const;
    /// Own drafts only.
    void edit_draft(const Session& educator, const std::string& comment_id, double time_s,
                    const std::string& text) const;
    void send(const Session& educator, const std::string& comment_id) const;
    void delete_draft(const Session& educator, const std::string& comment_id) const;
    std::vector<Comment> drafts(const Session& educator) const;
    /// Sent comments on the trainee's own attempts that they have not read, newest first.
    std::vector<Comment> unread(const Session& trainee) const;
    /// By the trainee whose attempt it is.
    void mark_read(const Session& trainee, const std::string& comment_id) const;

  private:
    const Store& store_;
};

}  // namespace fulcrum::database
