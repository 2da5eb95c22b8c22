// SPDX-License-Identifier: GPL-3.0-or-later
// A programme with at least one person inside and one outside of every scope, for tests of the access table.
#pragma once

#include <optional>

#include "assessment/assets/assets.h"
#include "database/records/goals.h"
#include "database/records/ratings.h"
#include "database/records/reviews.h"
#include "tests/database/access_expectation.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::app::program_test {

using namespace fulcrum::database;
using fulcrum::database::test::example_meta;
using fulcrum::database::test::example_result;
using fulcrum::database::test::expected_allowed;
using fulcrum::database::test::expected_scope;
using fulcrum::database::test::Programme;

/// A person whose data are requested (Ann also with a rating that is released, and one that is not), with an
/// attempt, a comment on it, a requested correction and a cohort.
struct Target {
    std::string login, person, attempt, comment, cohort_id, cohort;
};

/// "educator" teaches "Year 1" with Ann and Ben and is a trainee there too; "other_educator" teaches
/// "Elsewhere" with Eve; "synthetic-robot" is synthetic and in no cohort.
class AccessProgramme : public Programme {
  public:
    AccessProgramme() {
        const Session& director = session("director");
        people().set_roles(session("administrator"), id("educator"), {Role::trainee, Role::educator});
        people().set_members(director, cohort, {id("ann"), id("ben"), id("educator")});
        const std::string elsewhere = people().create_cohort(director, "Elsewhere");
        people().set_members(director, elsewhere, {id("eve")});
        people().set_educators(director, elsewhere, {id("other_educator")});
        educator = people().act_as(session("educator"), Role::educator);
        teacher = people().act_as(*educator, Role::trainee);
        const Person robot = people().ensure_synthetic(session("station"), "synthetic-robot", "Robot");
        ann = make_target("ann", session("ann"), id("ann"), cohort, "Year 1", &*educator);
        eve =
            make_target("eve", session("eve"), id("eve"), elsewhere, "Elsewhere", &session("other_educator"));
        own = make_target("educator", *teacher, id("educator"), cohort, "Year 1", nullptr);
        synthetic = make_target("synthetic-robot", session("station"), robot.id, "", "", nullptr);
        rate(session("director"), "goals");
        Ratings(*store).release(*educator, ann.attempt);
        rate(*educator, "osats");
        for (const Session& trainee : {session("ann"), session("eve"), *teacher})
            Goals(*store).set(trainee, {GoalOf::attempts, "A2", "", 3, 0}, 20'000);
    }

    /// The person of that role who makes the request.
    const Session& asker(Role role) const {
        switch (role) {
            case Role::trainee:
                return session("ann");
            case Role::educator:
                return *educator;
            case Role::director:
                return session("director");
            case Role::administrator:
                return session("administrator");
            case Role::station:
                break;
        }
        return session("station");
    }
    static const char* login_of(Role role) {
        switch (role) {
            case Role::trainee:
                return "ann";
            case Role::educator:
                return "educator";
            case Role::director:
                return "director";
            case Role::administrator:
                return "administrator";
            case Role::station:
                break;
        }
        return "station";
    }
    Relation relation(Role role, const Target& target) const {
        Relation relation;
        relation.own = role != Role::station && target.login == login_of(role);
        relation.in_cohort = role == Role::educator && target.cohort == "Year 1";
        relation.synthetic = target.login == "synthetic-robot";
        return relation;
    }
    /// Relation of a cohort to the person who asks: trainees are in it, educators teach it.
    static Relation cohort_relation(Role role, const Target& target) {
        Relation relation;
        relation.own = role == Role::trainee && target.cohort == "Year 1";
        relation.in_cohort = role == Role::educator && target.cohort == "Year 1";
        return relation;
    }

    Target ann, eve, own, synthetic;
    std::optional<Session> educator, teacher;

  private:
    /// A rating of Ann's attempt.
    void rate(const Session& rater, const std::string& form) const {
        const ObserverForm used = load_form(asset_path("forms/" + form + ".json"));
        const Ratings ratings(*store);
        const std::string id = ratings.begin(rater, ann.attempt, used);
        ratings.answer(rater, id, FormAnswers(used.items.size(), 3),
                       std::vector<bool>(used.items.size(), true), "");
        ratings.hand_in(rater, id);
    }
    Target make_target(const std::string& login, const Session& performer, const std::string& person,
                       const std::string& cohort_id, const std::string& cohort_name, const Session* author) {
        AttemptMeta meta = example_meta(person);
        if (login == "synthetic-robot") meta.device_class = DeviceClass::synthetic;
        Recorder recorder(path, performer, meta, clock.options());
        append_second(recorder);
        recorder.finish(example_result(true, 60));
        Target target{login, person, recorder.attempt_id(), "", cohort_id, cohort_name};
        if (author != nullptr) {
            target.comment = Reviews(*store).write(*author, target.attempt, 0.5, "Look here.", true);
            attempts().request_correction(performer, target.attempt, "this was not me");
        }
        return target;
    }
};

}  // namespace fulcrum::app::program_test
