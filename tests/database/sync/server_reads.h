// SPDX-License-Identifier: GPL-3.0-or-later
// Every call of this floor's rooms that reads a store: how it is asked, and whether a programme server
// answers it. server_reads_table_test.cpp finds the calls in the headers: a new one fails there until it has
// its row here, or in not_asked.h.
#pragma once

#include <string>

#include "database/records/external_attempts.h"
#include "database/records/ratings.h"
#include "database/records/reviews.h"
#include "database/records/standings.h"
#include "database/schedules/schedules.h"
#include "database/store/audit.h"
#include "database/sync/person_data.h"
#include "database/sync/retention.h"
#include "database/xapi/xapi_outbox.h"
#include "tests/database/sync/asked.h"

namespace fulcrum::database::test::reads {

struct Read {
    const char* name;
    std::string (*ask)(const Asked&);
};

/// Answered in the same words by a station and by the server. A row whose answer says nothing for anybody
/// fails too.
inline constexpr Read answered[] = {
    {"AcceptedAssets::is_to_accept",
     [](const Asked& q) {
         std::string all;
         for (const AssetFile& file : q.about.files) all += said(AcceptedAssets(q.store).is_to_accept(file));
         return all;
     }},
    {"AcceptedAssets::list", [](const Asked& q) { return said(AcceptedAssets(q.store).list()); }},
    {"AcceptedAssets::texts", [](const Asked& q) { return said(AcceptedAssets(q.store).texts()); }},
    {"AcceptedAssets::unknown",
     [](const Asked& q) { return said(AcceptedAssets(q.store).unknown(q.about.files)); }},
    {"Attempts::assets",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).assets(q.session, id); });
     }},
    {"Attempts::correction_requests",
     [](const Asked& q) { return said(Attempts(q.store).correction_requests(q.session)); }},
    {"Attempts::cut_off_series",
     [](const Asked& q) { return said(Attempts(q.store).cut_off_series(q.session)); }},
    {"Attempts::list",
     [](const Asked& q) {
         const Attempts attempts(q.store);
         std::string all = said(attempts.list(q.session));
         all += of_each(q.about.cohorts, [&](const std::string& id) {
             AttemptFilter filter;
             filter.cohort_id = id;
             filter.include_voided = false;
             filter.limit = 3;
             return attempts.list(q.session, filter);
         });
         for (const AttemptState state : {AttemptState::voided, AttemptState::interrupted}) {
             AttemptFilter filter;
             filter.state = state;
             filter.task_id = q.about.key.task;
             all += said(attempts.list(q.session, filter));
         }
         return all + of_each(q.about.people, [&](const std::string& id) {
                    AttemptFilter filter;
                    filter.person_id = id;
                    return attempts.list(q.session, filter);
                });
     }},
    {"Attempts::practised",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Attempts(q.store).practised(q.session, id, q.about.key.task);
         });
     }},
    {"Attempts::products",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).products(q.session, id); });
     }},
    {"Attempts::read",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).read(q.session, id); });
     }},
    {"Attempts::read_events",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).read_events(q.session, id); });
     }},
    {"Attempts::read_overview",
     [](const Asked& q) {
         return of_each(q.about.attempts, [&](const std::string& id) { return overview_of_attempt(q, id); });
     }},
    {"Attempts::read_packed_trace",
     [](const Asked& q) {
         return of_each(q.about.attempts, [&](const std::string& id) {
             return Attempts(q.store).read_packed_trace(q.session, id);
         });
     }},
    {"Attempts::read_trace",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).read_trace(q.session, id); });
     }},
    {"Attempts::record_digest",
     [](const Asked& q) {
         return of_each(q.about.attempts, [&](const std::string& id) {
             return Attempts(q.store).record_digest(q.session, id);
         });
     }},
    {"Attempts::scene_text",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).scene_text(q.session, id); });
     }},
    {"Attempts::score",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).score(q.session, id); });
     }},
    {"Attempts::scores",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).scores(q.session, id); });
     }},
    {"Attempts::start_state",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Attempts(q.store).start_state(q.session, id); });
     }},
    // One station has sent its log: the head and the key are its own.
    {"Audit::head", [](const Asked& q) { return Audit(q.store).head(); }},
    {"Audit::signing_key", [](const Asked& q) { return Audit(q.store).signing_key(); }},
    {"Curricula::assignments",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Curricula(q.store).assignments(q.session, id, q.about.curriculum);
         });
     }},
    {"Curricula::assignments_in",
     [](const Asked& q) {
         return of_each(q.about.cohorts, [&](const std::string& id) {
             std::map<std::string, BegunWith> begun_with;
             for (const std::string& person : q.about.people) begun_with[person];
             return Curricula(q.store).assignments_in(q.session, id, q.about.curriculum, begun_with);
         });
     }},
    {"Curricula::check",
     [](const Asked& q) {
         if (!sees_everything(q)) return std::string(hidden);
         Curricula(q.store).check(q.about.curriculum);
         return std::string("each version is the one that people follow");
     }},
    {"Curricula::followed",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Curricula(q.store).followed(q.session, id, q.about.curriculum);
         });
     }},
    {"Curricula::in_force",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Curricula(q.store).in_force(q.session, id, q.about.curriculum).name();
         });
     }},
    {"Curricula::missing",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             const std::string name = Curricula(q.store).missing(q.session, id, q.about.curriculum);
             return name.empty() ? std::string("all are here") : name;
         });
     }},
    {"Curricula::of_account",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Curricula(q.store).of_account(q.session, id, id, q.about.curriculum);
         });
     }},
    {"Curricula::people",
     [](const Asked& q) {
         return sees_everything(q) ? said(Curricula(q.store).people(q.about.curriculum))
                                   : std::string(hidden);
     }},
    {"Curricula::preview",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Curricula(q.store).preview(q.session, id, q.about.curriculum,
                                               q.about.curriculum.older.back().name());
         });
     }},
    {"Curricula::require_here",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             Curricula(q.store).require_here(q.session, id, q.about.curriculum);
             return std::string("is here");
         });
     }},
    {"ErrorReviews::history",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return ErrorReviews(q.store).history(q.session, id); });
     }},
    {"ErrorReviews::in_force",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return ErrorReviews(q.store).in_force(q.session, id); });
     }},
    {"ExternalAttempts::trace",
     [](const Asked& q) {
         return of_each(q.about.attempts, [&](const std::string& id) {
             return ExternalAttempts(q.store).trace(q.session, id);
         });
     }},
    {"Goals::latest_value",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Goals(q.store).latest_value(q.session, id, q.about.key.task, "path_len");
         });
     }},
    {"Goals::of_person",
     [](const Asked& q) {
         return of_each(q.about.people,
                        [&](const std::string& id) { return Goals(q.store).of_person(q.session, id); });
     }},
    {"Goals::progress",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Goals(q.store).progress(q.session, id, q.today());
         });
     }},
    {"People::cohorts", [](const Asked& q) { return said(People(q.store).cohorts(q.session)); }},
    {"People::find",
     [](const Asked& q) {
         return of_each(q.about.people,
                        [&](const std::string& id) { return found(People(q.store).find(q.session, id)); });
     }},
    {"People::find_cohort",
     [](const Asked& q) {
         return of_each(q.about.cohorts, [&](const std::string& id) {
             return found(People(q.store).find_cohort(q.session, id));
         });
     }},
    {"People::find_login",
     [](const Asked& q) {
         return of_each(q.about.logins, [&](const std::string& login) {
             return found(People(q.store).find_login(q.session, login));
         });
     }},
    {"People::list", [](const Asked& q) { return said(People(q.store).list(q.session)); }},
    {"People::login_now", [](const Asked& q) { return People(q.store).login_now(q.session); }},
    {"Ratings::of_attempt",
     [](const Asked& q) {
         return of_each(q.about.attempts, [&](const std::string& id) {
             return said_to(q.session, Ratings(q.store).of_attempt(q.session, id));
         });
     }},
    {"Ratings::of_person",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             std::string all;
             for (const auto& [attempt, ratings] : Ratings(q.store).of_person(q.session, id))
                 if (!ratings.rows.empty() || !q.is(Role::trainee))
                     all += attempt + said_to(q.session, ratings);
             return all;
         });
     }},
    {"Reports::attempt_report",
     [](const Asked& q) {
         return of_each(q.about.attempts, [&](const std::string& id) {
             return Reports(q.store).attempt_report(q.session, id);
         });
     }},
    {"Reports::cohort_table",
     [](const Asked& q) {
         return of_each(q.about.cohorts, [&](const std::string& id) {
             const CohortTable table = Reports(q.store).cohort_table(q.session, id, table_options(q.about));
             DashboardOptions options;
             options.at = table.as_of;
             return said(table) + said(dashboard_of(table.standings, q.about.curriculum, options));
         });
     }},
    {"Reports::each_of_cohort",
     [](const Asked& q) {
         return of_each(q.about.cohorts, [&](const std::string& id) {
             std::string all;
             for (const PointDetail detail : {PointDetail::metrics, PointDetail::all})
                 Reports(q.store).each_of_cohort(q.session, id, data_options(q.about, detail),
                                                 [&](PersonData&& data, double) {
                                                     all += said(data);
                                                     return true;
                                                 });
             return all;
         });
     }},
    {"Reports::person_data",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Reports(q.store).person_data(q.session, id, data_options(q.about, PointDetail::all));
         });
     }},
    {"Reports::person_progress",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Reports(q.store).person_progress(q.session, id, q.about.key.task);
         });
     }},
    {"Reports::person_table",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Reports(q.store).person_table(q.session, id, q.about.tasks);
         });
     }},
    {"Reports::standings",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Reports(q.store).standings(q.session, id, q.about.curriculum);
         });
     }},
    {"Reports::table_with_people",
     [](const Asked& q) {
         return of_each(q.about.cohorts, [&](const std::string& id) {
             std::string all;
             const auto table = Reports(q.store).table_with_people(
                 q.session, id, table_options(q.about), data_options(q.about, PointDetail::all),
                 [&](const CohortTable&, PersonData&& data, double) {
                     all += said(data);
                     return true;
                 });
             return all + found(table);
         });
     }},
    {"Reviews::comments",
     [](const Asked& q) {
         return of_each(q.about.attempts,
                        [&](const std::string& id) { return Reviews(q.store).comments(q.session, id); });
     }},
    {"Reviews::unread",
     [](const Asked& q) { return unless_hidden([&] { return Reviews(q.store).unread(q.session); }); }},
    {"Standings::overrides",
     [](const Asked& q) {
         return of_each(q.about.people,
                        [&](const std::string& id) { return Standings(q.store).overrides(q.session, id); });
     }},
    {"Standings::record",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return Standings(q.store).record(q.session, id, q.about.curriculum);
         });
     }},
    {"certificates",
     [](const Asked& q) {
         return of_each(q.about.people, [&](const std::string& id) {
             return certificates(q.store, q.session, id, q.about.curriculum);
         });
     }},
    // At a station whoever checks the store asks, at a server the account, of what it sees.
    {"checkable_attempts",
     [](const Asked& q) {
         if (!sees_everything(q)) return std::string(hidden);
         return said(checkable_attempts(q.store, q.store.is_server() ? q.session : q.store.station_session(),
                                        "0.1.0", ""));
     }},
    {"read_checked_attempt",
     [](const Asked& q) {
         if (!sees_everything(q)) return std::string(hidden);
         return of_each(q.about.attempts, [&](const std::string& id) {
             return read_checked_attempt(q.store, q.store.is_server() ? q.session : q.store.station_session(),
                                         id);
         });
     }},
    {"expert_attempts",
     [](const Asked& q) {
         return said(
             expert_attempts(q.store, q.session, q.about.loaded, q.about.key.device_class,
                             expert_candidates(q.store, q.session, q.about.loaded.task, q.about.key)));
     }},
    {"expert_candidates",
     [](const Asked& q) {
         return said(expert_candidates(q.store, q.session, q.about.loaded.task, q.about.key));
     }},
    {"find_certificate",
     [](const Asked& q) {
         return of_each(q.about.codes, [&](const std::string& code) {
             return found(find_certificate(q.store, q.session, code, q.about.curriculum));
         });
     }},
    {"research_export",
     [](const Asked& q) {
         return unless_hidden([&] { return said_of_research(research_export(q.store, q.session)); });
     }},
    {"tried_attempts",
     [](const Asked& q) {
         return said(tried_attempts(q.store, q.session, q.about.loaded.task, q.about.key));
     }},
};

/// Read at stations only. The server refuses them in the words of the access table.
struct Refused {
    const char* name;
    std::string (*ask)(const Asked&);
    const char* why;
};
inline constexpr Refused refused[] = {
    {"Attempts::interrupted_without_score",
     [](const Asked& q) { return said(Attempts(q.store).interrupted_without_score(q.session)); },
     "the list of what is scored next, at the station that has the record"},
    {"Attempts::stale_scores",
     [](const Asked& q) {
         ScoringInForce now;
         now.limits = [](const AttemptMeta&) { return std::string(); };
         return said(Attempts(q.store).stale_scores(q.session, now));
     },
     "the list of what is computed again, at the station that has the record"},
    {"People::recent_sign_ins",
     [](const Asked& q) { return std::to_string(People(q.store).recent_sign_ins(q.session).size()); },
     "who signed in at one machine"},
    {"Ratings::agreement",
     [](const Asked& q) { return std::to_string(Ratings(q.store).agreement(q.session).size()); },
     "of those who rate, which is done at a station"},
    {"Ratings::to_rate",
     [](const Asked& q) {
         return std::to_string(Ratings(q.store).to_rate(q.session, &q.about.curriculum).size());
     },
     "rating is done at a station, blind"},
    {"Reviews::drafts", [](const Asked& q) { return said(Reviews(q.store).drafts(q.session)); },
     "drafts stay at the station"},
    {"Schedules::list",
     [](const Asked& q) { return std::to_string(Schedules(q.store).list(q.session).size()); },
     "schedules are settings, which are not exchanged"},
    {"XapiOutbox::counts",
     [](const Asked& q) { return std::to_string(XapiOutbox(q.store, q.session, "x").counts().waiting); },
     "the queue stays at the station that sends"},
    {"XapiOutbox::next",
     [](const Asked& q) { return std::string(XapiOutbox(q.store, q.session, "x").next() ? "one" : "none"); },
     "the queue stays at the station that sends"},
    {"XapiOutbox::quarantined",
     [](const Asked& q) { return std::to_string(XapiOutbox(q.store, q.session, "x").quarantined().size()); },
     "the queue stays at the station that sends"},
    {"export_person_data",
     [](const Asked& q) {
         return std::to_string(export_person_data(q.store, q.session, q.about.trainee, {}).rows.size());
     },
     "all data of a person is audited, and a server has no log of its own"},
    {"outbox_counts", [](const Asked& q) { return std::to_string(outbox_counts(q.store, q.session).size()); },
     "the queue stays at the station that sends"},
    {"people_due", [](const Asked& q) { return std::to_string(people_due(q.store, q.session).size()); },
     "the time for which data are kept is a setting, and only `fulcrum server` erases at a server"},
};

}  // namespace fulcrum::database::test::reads
