// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/draft_merge.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {
namespace {

using Ids = std::vector<std::string>;

const std::string& id_of(const CurriculumStage& stage) {
    return stage.id;
}
const std::string& id_of(const CurriculumTask& task) {
    return task.task;
}

template <typename Item>
const Item* find_item(const std::vector<Item>& items, const std::string& id) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const Item& one) { return id_of(one) == id; });
    return found == items.end() ? nullptr : &*found;
}

template <typename Item>
Item* find_item(std::vector<Item>& items, const std::string& id) {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const Item& one) { return id_of(one) == id; });
    return found == items.end() ? nullptr : &*found;
}

bool contains(const Ids& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Each once: a draft may list one twice, which its author has to solve.
template <typename Item>
Ids ids_of(const std::vector<Item>& items) {
    Ids ids;
    for (const Item& one : items)
        if (!contains(ids, id_of(one))) ids.push_back(id_of(one));
    return ids;
}

template <typename Value>
bool same_set(std::vector<Value> a, std::vector<Value> b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    return a == b;
}

bool same_ratings(const std::optional<RatingRule>& a, const std::optional<RatingRule>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    const auto same_mean = [](double x, double y) { return !(x < y) && !(y < x); };
    return a->form == b->form && a->raters == b->raters && same_mean(a->lowest_mean, b->lowest_mean) &&
           same_set(a->items, b->items) && a->every_item == b->every_item && a->blind == b->blind;
}

template <auto member>
bool same_value(const CurriculumTask& a, const CurriculumTask& b) {
    return a.*member == b.*member;
}
template <auto member>
bool same_values(const CurriculumTask& a, const CurriculumTask& b) {
    return same_set(a.*member, b.*member);
}
bool same_rule(const CurriculumTask& a, const CurriculumTask& b) {
    return pass_rule_text(a.rule) == pass_rule_text(b.rule);
}
bool same_ratings_of(const CurriculumTask& a, const CurriculumTask& b) {
    return same_ratings(a.ratings, b.ratings);
}
template <auto member>
void copy_value(CurriculumTask& to, const CurriculumTask& from) {
    to.*member = from.*member;
}

using Left = std::vector<DraftDifference>;

// Of the whole curriculum, of its stages (`list`) and tasks; defined below.
void take_title(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one);
template <auto list>
void take_order_of(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one);
template <auto list>
void take_item_of(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one);
void take_field(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one);
void look_at_title(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                   Left& left);
template <auto list>
void look_at_order(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                   Left& left);
void look_at_stage(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                   Left& left);
void look_at_task(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                  Left& left);

struct PartRow {
    DraftPart kind;
    /// Puts the value of the version in force in the place of the draft's own.
    void (*take)(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one);
    /// What of a collision is left, any number of them.
    void (*look)(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one, Left& left);
    /// Of a field of a task; null for the others.
    bool (*same)(const CurriculumTask& a, const CurriculumTask& b) = nullptr;
    void (*copy)(CurriculumTask& to, const CurriculumTask& from) = nullptr;
};
constexpr PartRow draft_parts[] = {
    {DraftPart::title, take_title, look_at_title},
    {DraftPart::stage_order, take_order_of<&Curriculum::stages>, look_at_order<&Curriculum::stages>},
    {DraftPart::stage, take_item_of<&Curriculum::stages>, look_at_stage},
    {DraftPart::stage_title, take_item_of<&Curriculum::stages>, look_at_stage},
    {DraftPart::task_order, take_order_of<&Curriculum::tasks>, look_at_order<&Curriculum::tasks>},
    {DraftPart::task, take_item_of<&Curriculum::tasks>, look_at_task},
    {DraftPart::task_stage, take_field, look_at_task, same_value<&CurriculumTask::stage>,
     copy_value<&CurriculumTask::stage>},
    {DraftPart::after, take_field, look_at_task, same_values<&CurriculumTask::after>,
     copy_value<&CurriculumTask::after>},
    {DraftPart::rule, take_field, look_at_task, same_rule, copy_value<&CurriculumTask::rule>},
    {DraftPart::variants, take_field, look_at_task, same_value<&CurriculumTask::variants>,
     copy_value<&CurriculumTask::variants>},
    {DraftPart::devices, take_field, look_at_task, same_values<&CurriculumTask::device_classes>,
     copy_value<&CurriculumTask::device_classes>},
    {DraftPart::ratings, take_field, look_at_task, same_ratings_of, copy_value<&CurriculumTask::ratings>},
    {DraftPart::remedies, take_field, look_at_task, same_value<&CurriculumTask::remedies>,
     copy_value<&CurriculumTask::remedies>},
};
static_assert(in_order(draft_parts) &&
                  std::size(draft_parts) == static_cast<std::size_t>(DraftPart::remedies) + 1,
              "a row for every part, in the enum's order");

bool same_item(const CurriculumStage& a, const CurriculumStage& b) {
    return a.title == b.title;
}
bool same_item(const CurriculumTask& a, const CurriculumTask& b) {
    return std::all_of(std::begin(draft_parts), std::end(draft_parts),
                       [&](const PartRow& row) { return row.same == nullptr || row.same(a, b); });
}

/// The ids of `first` in their order, and those of `second` alone each behind the one that is before it
/// there; of both those that are to be kept.
template <typename Keep>
Ids in_one_order(const Ids& first, const Ids& second, const Keep& keep) {
    Ids result;
    for (const std::string& id : first)
        if (keep(id)) result.push_back(id);
    for (std::size_t i = 0; i < second.size(); ++i) {
        if (!keep(second[i]) || contains(result, second[i])) continue;
        auto place = result.begin();
        for (std::size_t before = i; before > 0; --before) {
            const auto found = std::find(result.begin(), result.end(), second[before - 1]);
            if (found == result.end()) continue;
            place = found + 1;
            break;
        }
        result.insert(place, second[i]);
    }
    return result;
}

/// The ids of `ids` that `other` has too.
Ids also_in(const Ids& ids, const Ids& other) {
    Ids found;
    for (const std::string& id : ids)
        if (contains(other, id)) found.push_back(id);
    return found;
}

template <typename Item>
bool same_order(const std::vector<Item>& a, const std::vector<Item>& b) {
    const Ids of_a = ids_of(a), of_b = ids_of(b);
    return also_in(of_a, of_b) == also_in(of_b, of_a);
}

enum class Winner { draft, in_force, neither };

/// `base` null: not known.
template <typename Value, typename Same>
Winner winner_of(const Value* base, const Value& draft, const Value& in_force, const Same& same) {
    if (same(draft, in_force)) return Winner::draft;
    if (base != nullptr && same(*base, draft)) return Winner::in_force;
    if (base != nullptr && same(*base, in_force)) return Winner::draft;
    return Winner::neither;
}

const auto equal = [](const auto& a, const auto& b) { return a == b; };

/// The remark at the top of a file, as it is written there.
std::string remark_of(const Curriculum& curriculum) {
    const auto root = nlohmann::json::parse(curriculum.text, nullptr, false);
    return root.is_object() && root.contains("$comment") ? root["$comment"].dump() : std::string();
}

class Merging {
  public:
    Merging(const Curriculum* base, const Curriculum& draft, const Curriculum& in_force)
        : base_(base), draft_(draft), in_force_(in_force) {}

    DraftMerge run() {
        result_.draft = draft_;
        if (base_ != nullptr && remark_of(*base_) == remark_of(draft_)) result_.draft.text = in_force_.text;
        const std::string* before = base_ == nullptr ? nullptr : &base_->title;
        if (is_taken(DraftPart::title, {}, winner_of(before, draft_.title, in_force_.title, equal)))
            result_.draft.title = in_force_.title;
        result_.draft.stages = merged_items(base_ == nullptr ? nullptr : &base_->stages, draft_.stages,
                                            in_force_.stages, DraftPart::stage, DraftPart::stage_order);
        result_.draft.tasks = merged_items(base_ == nullptr ? nullptr : &base_->tasks, draft_.tasks,
                                           in_force_.tasks, DraftPart::task, DraftPart::task_order);
        return std::move(result_);
    }

  private:
    /// Whether the value of the version in force is to be used; notes what became of the part.
    bool is_taken(DraftPart part, const std::string& of, Winner winner) {
        if (winner == Winner::in_force) result_.taken.push_back({part, of});
        if (winner == Winner::neither) result_.collisions.push_back({part, of});
        return winner == Winner::in_force;
    }

    CurriculumStage in_both(const CurriculumStage* before, const CurriculumStage& own,
                            const CurriculumStage& other) {
        CurriculumStage merged = own;
        const std::string* title = before == nullptr ? nullptr : &before->title;
        if (is_taken(DraftPart::stage_title, own.id, winner_of(title, own.title, other.title, equal)))
            merged.title = other.title;
        return merged;
    }
    CurriculumTask in_both(const CurriculumTask* before, const CurriculumTask& own,
                           const CurriculumTask& other) {
        CurriculumTask merged = own;
        for (const PartRow& row : draft_parts)
            if (row.same != nullptr && is_taken(row.kind, own.task, winner_of(before, own, other, row.same)))
                row.copy(merged, other);
        return merged;
    }

    /// Whether what only one of the two has stays; notes it where it does so by the version in force, or
    /// where nobody can say.
    template <typename Item>
    bool stays(const std::vector<Item>* base, const Item* own, const Item& one, DraftPart part) {
        const Item* before = base == nullptr ? nullptr : find_item(*base, id_of(one));
        const bool of_draft = own != nullptr;
        if (base != nullptr && before == nullptr) {  // one of the two added it
            if (!of_draft) result_.taken.push_back({part, id_of(one)});
            return true;
        }
        if (before != nullptr && same_item(*before, one)) {  // the other one removed it
            if (of_draft) result_.taken.push_back({part, id_of(one)});
            return false;
        }
        result_.collisions.push_back({part, id_of(one)});
        return of_draft;
    }

    template <typename Item>
    std::vector<Item> merged_items(const std::vector<Item>* base, const std::vector<Item>& draft,
                                   const std::vector<Item>& in_force, DraftPart part, DraftPart order) {
        const Ids own_ids = ids_of(draft), other_ids = ids_of(in_force);
        std::map<std::string, Item> kept;
        for (const std::string& id :
             in_one_order(own_ids, other_ids, [](const std::string&) { return true; })) {
            const Item* own = find_item(draft, id);
            const Item* other = find_item(in_force, id);
            if (own != nullptr && other != nullptr) {
                const Item* before = base == nullptr ? nullptr : find_item(*base, id);
                kept.emplace(id, in_both(before, *own, *other));
            } else {
                const Item& one = own != nullptr ? *own : *other;
                if (stays(base, own, one, part)) kept.emplace(id, one);
            }
        }
        // The order of those that all have.
        Ids before, own = also_in(own_ids, other_ids), other = also_in(other_ids, own_ids);
        if (base != nullptr) {
            before = also_in(also_in(ids_of(*base), own_ids), other_ids);
            own = also_in(own, before);
            other = also_in(other, before);
        }
        const bool by_other =
            is_taken(order, {}, winner_of(base == nullptr ? nullptr : &before, own, other, equal));
        const auto is_kept = [&](const std::string& id) { return kept.count(id) != 0; };
        std::vector<Item> result;
        for (const std::string& id :
             by_other ? in_one_order(other_ids, own_ids, is_kept) : in_one_order(own_ids, other_ids, is_kept))
            result.push_back(kept.at(id));
        std::set<std::string> listed;
        for (const Item& one : draft)
            if (!listed.insert(id_of(one)).second && is_kept(id_of(one))) result.push_back(one);
        return result;
    }

    const Curriculum* base_;
    const Curriculum& draft_;
    const Curriculum& in_force_;
    DraftMerge result_;
};

/// Puts the item in where `from` has it, or takes it out.
template <typename Item>
void take_item(std::vector<Item>& to, const std::vector<Item>& from, const std::string& id) {
    const Item* wanted = find_item(from, id);
    if (wanted == nullptr) {
        to.erase(std::remove_if(to.begin(), to.end(), [&](const Item& one) { return id_of(one) == id; }),
                 to.end());
        return;
    }
    if (Item* own = find_item(to, id)) {
        *own = *wanted;
        return;
    }
    const Ids order = in_one_order(ids_of(to), ids_of(from), [&](const std::string& one) {
        return one == id || find_item(to, one) != nullptr;
    });
    const auto place = std::find(order.begin(), order.end(), id) - order.begin();
    // What is listed twice comes behind: no place of theirs changes.
    to.insert(to.begin() + std::min(place, static_cast<std::ptrdiff_t>(to.size())), *wanted);
}

template <typename Item>
void take_order(std::vector<Item>& to, const std::vector<Item>& from) {
    const Ids order = in_one_order(ids_of(from), ids_of(to),
                                   [&](const std::string& id) { return find_item(to, id) != nullptr; });
    std::stable_sort(to.begin(), to.end(), [&](const Item& a, const Item& b) {
        const auto place = [&](const Item& one) { return std::find(order.begin(), order.end(), id_of(one)); };
        return place(a) < place(b);
    });
}

/// What of this difference is left, any number of them.
template <typename Item>
void look_again(const std::vector<Item>& draft, const std::vector<Item>& in_force, const DraftDifference& one,
                DraftPart presence, std::vector<DraftDifference>& left) {
    const Item* own = find_item(draft, one.of);
    const Item* other = find_item(in_force, one.of);
    if ((own == nullptr) != (other == nullptr)) left.push_back({presence, one.of});
    if (own == nullptr || other == nullptr) return;
    if constexpr (std::is_same_v<Item, CurriculumStage>) {
        if (own->title != other->title) left.push_back({DraftPart::stage_title, one.of});
    } else {
        for (const PartRow& row : draft_parts)
            if (row.same != nullptr && (one.part == presence || one.part == row.kind) &&
                !row.same(*own, *other))
                left.push_back({row.kind, one.of});
    }
}

void take_title(Curriculum& draft, const Curriculum& in_force, const DraftDifference& /*one*/) {
    draft.title = in_force.title;
}
template <auto list>
void take_order_of(Curriculum& draft, const Curriculum& in_force, const DraftDifference& /*one*/) {
    take_order(draft.*list, in_force.*list);
}
template <auto list>
void take_item_of(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one) {
    take_item(draft.*list, in_force.*list, one.of);
}
void take_field(Curriculum& draft, const Curriculum& in_force, const DraftDifference& one) {
    CurriculumTask* own = find_item(draft.tasks, one.of);
    const CurriculumTask* other = in_force.find(one.of);
    if (own != nullptr && other != nullptr) row_of(draft_parts, one.part).copy(*own, *other);
}

void look_at_title(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                   Left& left) {
    if (draft.title != in_force.title) left.push_back(one);
}
template <auto list>
void look_at_order(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                   Left& left) {
    if (!same_order(draft.*list, in_force.*list)) left.push_back(one);
}
void look_at_stage(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                   Left& left) {
    look_again(draft.stages, in_force.stages, one, DraftPart::stage, left);
}
void look_at_task(const Curriculum& draft, const Curriculum& in_force, const DraftDifference& one,
                  Left& left) {
    look_again(draft.tasks, in_force.tasks, one, DraftPart::task, left);
}

}  // namespace

DraftMerge merge_draft(const Curriculum* base, const Curriculum& draft, const Curriculum& in_force) {
    return Merging(base, draft, in_force).run();
}

void take_part(Curriculum& draft, const Curriculum& in_force, const DraftDifference& part) {
    row_of(draft_parts, part.part).take(draft, in_force, part);
}

std::vector<DraftDifference> collisions_left(const std::vector<DraftDifference>& collisions,
                                             const Curriculum& draft, const Curriculum& in_force) {
    Left left;
    for (const DraftDifference& one : collisions)
        row_of(draft_parts, one.part).look(draft, in_force, one, left);
    std::vector<DraftDifference> once;
    for (const DraftDifference& one : left)
        if (std::find(once.begin(), once.end(), one) == once.end()) once.push_back(one);
    return once;
}

}  // namespace fulcrum
