// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/scene.h"

#include <set>

#include "sim_core/scene/cutting_values.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/json_names.h"
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"
#include "sim_core/scene/scene_schema.h"

namespace fulcrum {

namespace {

using nlohmann::json;

using scene_json::copy;
using scene_json::copy_degrees;

class SceneReader {
  public:
    explicit SceneReader(const JsonDocument& document) : document_(document) {}

    Scene read() {
        const json& root = document_.root();
        copy(root, "id", scene_.id);
        copy(root, "version", scene_.version);
        copy(root, "variant", scene_.variant);
        copy(root, "gravity", scene_.gravity);
        copy(root, "tick_rate", scene_.tick_rate);
        copy(root, "ticks_per_step", scene_.ticks_per_step);
        copy(root, "force_limit", scene_.force_limit);
        copy(root, "passivity_control", scene_.passivity_control);
        copy(root, "slew_limit", scene_.slew_limit);
        read_tissues(root.at("tissues"));
        read_instruments(root.at("instruments"));
        if (root.contains("camera")) scene_.camera = read_camera(root.at("camera"));
        const PartReading reading = {document_, scene_};
#define SCENE_PART(type, name) \
    if (root.contains(#name)) read_##name(reading, root.at(#name));
#include "sim_core/scene/scene_parts.inc"
        if (scene_.instruments.empty() && !scene_.camera_targets) {
            document_.fail(
                "/instruments",
                QT_TRANSLATE_NOOP("errors", "a scene needs instruments or targets for the camera"),
                QT_TRANSLATE_NOOP("errors", "give at least one instrument, or \"camera_targets\""));
        }
        if (root.contains("fidelity")) read_fidelity(root.at("fidelity"));
        return std::move(scene_);
    }

  private:
    void read_tissues(const json& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& node = list[i];
            const std::string place = "/tissues/" + std::to_string(i);
            TissueSpec tissue;
            copy(node, "label", tissue.label);
            copy(node, "force_limit", tissue.force_limit);
            copy(node, "perforation_force", tissue.perforation_force);
            copy(node, "perforation_spread", tissue.perforation_spread);
            copy(node, "jaw_pressure_limit", tissue.jaw_pressure_limit);
            copy(node, "jaw_force_time_limit", tissue.jaw_force_time_limit);
            copy(node, "friction", tissue.friction);
            copy(node, "stiffness", tissue.stiffness);
            copy(node, "damping", tissue.damping);
            if (node.contains("cutting"))
                tissue.cutting = read_cutting(node.at("cutting"), place + "/cutting", tissue);
            if (scene_.tissue_index(tissue.label) >= 0) {
                document_.fail(
                    place + "/label",
                    {QT_TRANSLATE_NOOP("errors", "the tissue \"%1\" is given twice"), tissue.label},
                    QT_TRANSLATE_NOOP("errors", "give every tissue its own label"));
            }
            // A spread of half the median would give limits near zero in some attempts.
            if (tissue.perforation_spread > 0.4 * tissue.perforation_force) {
                document_.fail(
                    place + "/perforation_spread",
                    QT_TRANSLATE_NOOP("errors", "the spread is above 0.4 of perforation_force"),
                    QT_TRANSLATE_NOOP("errors", "give a smaller spread or a larger perforation_force"));
            }
            scene_.tissues.push_back(tissue);
        }
    }

    CuttingSpec read_cutting(const json& node, const std::string& place, const TissueSpec& tissue) {
        CuttingSpec cutting;
        for (const CuttingKey& key : cutting_keys) copy(node, key.key, cutting.*key.value);
        if (cutting.dynamic_friction > cutting.static_friction) {
            document_.fail(place + "/dynamic_friction_n",
                           QT_TRANSLATE_NOOP("errors", "dynamic_friction_n is above static_friction_n"),
                           QT_TRANSLATE_NOOP("errors", "give at most the value of static_friction_n"));
        }
        if (!(tissue.friction > 0)) {
            document_.fail(
                place,
                QT_TRANSLATE_NOOP(
                    "errors",
                    "a tissue without friction carries no force along it, so no blade can break through"),
                QT_TRANSLATE_NOOP("errors", "give the tissue a friction above 0"));
        }
        return cutting;
    }

    TrocarSpec read_trocar(const json& node, const std::string& place) {
        TrocarSpec trocar;
        copy(node, "position", trocar.position);
        copy(node, "direction", trocar.direction);
        copy(node, "up", trocar.up);
        copy(node, "shaft_length", trocar.shaft_length);
        if (trocar.position.norm() > 1.0) {
            document_.fail(place + "/position",
                           QT_TRANSLATE_NOOP("errors", "the trocar is more than 1 m from the pelvis"),
                           QT_TRANSLATE_NOOP("errors", "give metres, not millimetres"));
        }
        if (trocar.direction.norm() < 1e-6) {
            document_.fail(place + "/direction", QT_TRANSLATE_NOOP("errors", "the direction has no length"),
                           QT_TRANSLATE_NOOP("errors", "give a vector from the trocar into the body"));
        }
        trocar.direction.normalize();
        if (trocar.up.norm() < 1e-6 || trocar.direction.cross(trocar.up.normalized()).norm() < 0.05) {
            document_.fail(
                node.contains("up") ? place + "/up" : place,
                QT_TRANSLATE_NOOP("errors", "up is parallel to the direction"),
                QT_TRANSLATE_NOOP("errors", "give an up vector at least 3 degrees away from the shaft"));
        }
        return trocar;
    }

    void check_insertion(double insertion, const TrocarSpec& trocar, const std::string& place) {
        if (insertion > 0.9 * trocar.shaft_length) {
            document_.fail(
                place + "/start_insertion",
                QT_TRANSLATE_NOOP("errors", "the start insertion exceeds 0.9 of the shaft's length"),
                QT_TRANSLATE_NOOP("errors", "give a smaller start_insertion or a longer shaft_length"));
        }
    }

    void read_instruments(const json& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& node = list[i];
            const std::string place = "/instruments/" + std::to_string(i);
            InstrumentSpec instrument;
            copy_named(document_, node, place, "hand", hand_names, instrument.hand);
            if (scene_.instrument(instrument.hand) != nullptr) {
                document_.fail(place + "/hand",
                               {QT_TRANSLATE_NOOP("errors", "the %1 hand holds two instruments"),
                                hand_name(instrument.hand)},
                               QT_TRANSLATE_NOOP("errors", "give each hand one instrument"));
            }
            copy_named(document_, node, place, "kind", instrument_types, instrument.kind);
            if (node.contains("exchange")) {
                for (std::size_t k = 0; k < node.at("exchange").size(); ++k)
                    instrument.exchange.push_back(named(document_, node.at("exchange")[k],
                                                        place + "/exchange/" + std::to_string(k),
                                                        instrument_types));
            }
            if (!instrument.exchange.empty()) {
                if (!document_.root().contains("bands") && !document_.root().contains("structures")) {
                    document_.fail(
                        place + "/exchange",
                        QT_TRANSLATE_NOOP("errors", "instruments are exchanged where nothing needs another"),
                        QT_TRANSLATE_NOOP(
                            "errors", "add \"bands\" or \"structures\" to the scene or remove \"exchange\""));
                }
                if (node.contains("kind") && instrument.kind != instrument.exchange.front()) {
                    document_.fail(
                        place + "/exchange",
                        QT_TRANSLATE_NOOP("errors", "the first of \"exchange\" is not \"kind\""),
                        QT_TRANSLATE_NOOP("errors", "start the list with what the hand holds at the start"));
                }
                instrument.kind = instrument.exchange.front();
            }
            const InstrumentType& type = type_of(instrument.kind);
            instrument.jaw_length = type.jaw_length;
            instrument.tip_box = Vector3(type.jaw_length, type.jaw_width, type.jaw_width);
            instrument.trocar = read_trocar(node.at("trocar"), place + "/trocar");
            copy(node, "start_insertion", instrument.start_insertion);
            copy(node, "shaft_radius", instrument.shaft_radius);
            copy(node, "tip_radius", instrument.tip_radius);
            copy(node, "tip_box", instrument.tip_box);
            copy(node, "jaw_length", instrument.jaw_length);
            copy_degrees(node, "jaw_opening_deg", instrument.jaw_opening);
            copy(node, "grip_force", instrument.grip_force);
            check_insertion(instrument.start_insertion, instrument.trocar, place);
            scene_.instruments.push_back(instrument);
        }
    }

    CameraSpec read_camera(const json& node) {
        CameraSpec camera;
        camera.trocar = read_trocar(node.at("trocar"), "/camera/trocar");
        copy(node, "start_insertion", camera.start_insertion);
        copy_degrees(node, "angle_deg", camera.angle);
        copy_degrees(node, "field_of_view_deg", camera.field_of_view);
        check_insertion(camera.start_insertion, camera.trocar, "/camera");
        return camera;
    }

    void read_fidelity(const json& node) {
        Fidelity& fidelity = scene_.fidelity;
        copy(node, "id", fidelity.id);
        const std::string place = "/fidelity";
        copy_named(document_, node, place, "rod", rod_levels, fidelity.rod);
        copy(node, "rod_iterations", fidelity.rod_iterations);
        copy_named(document_, node, place, "material", material_laws, fidelity.material);
        copy_named(document_, node, place, "skinning", skin_scopes, fidelity.skinning);
        copy_named(document_, node, place, "collision", collision_searches, fidelity.collision);
        copy(node, "projection_iterations", fidelity.projection_iterations);
        copy_named(document_, node, place, "tool_contact", tool_contact_levels, fidelity.tool_contact);
        copy_named(document_, node, place, "membrane", membrane_integrators, fidelity.membrane);
        copy(node, "membrane_iterations", fidelity.membrane_iterations);
        copy_named(document_, node, place, "filter", filter_levels, fidelity.filter);
    }

    const JsonDocument& document_;
    Scene scene_;
};

}  // namespace

void PartReading::check_tissue(const std::string& place, const std::string& label) const {
    if (scene.tissue_index(label) >= 0) return;
    std::string known;
    for (const TissueSpec& tissue : scene.tissues) known += (known.empty() ? "" : ", ") + tissue.label;
    document.fail(place + "/tissue",
                  {QT_TRANSLATE_NOOP("errors", "the tissue \"%1\" is not in the list of tissues"), label},
                  {QT_TRANSLATE_NOOP("errors", "use one of: %1, or add it to \"tissues\""), known});
}

Scene parse_scene(const std::string& text, const std::string& file) {
    const JsonDocument document = JsonDocument::parse(text, file);
    document.check_schema(scene_schema().c_str());
    return SceneReader(document).read();
}

Scene load_scene(const std::string& path) {
    return parse_scene(read_text_file(path, JsonLimits().bytes), path);
}

}  // namespace fulcrum
