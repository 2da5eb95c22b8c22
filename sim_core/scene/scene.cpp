// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/scene.h"

#include <cmath>
#include <set>

#include "sim_core/scene/bands_reader.h"
#include "sim_core/scene/bowel_reader.h"
#include "sim_core/scene/camera_targets_reader.h"
#include "sim_core/scene/cutting_values.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/json_names.h"
#include "sim_core/scene/objects_reader.h"
#include "sim_core/scene/scene_json.h"
#include "sim_core/scene/septa_reader.h"
#include "sim_core/scene/structures_reader.h"

namespace fulcrum {

extern const char* const scene_schema_text;  // assets/schemas/scene.schema.json, embedded by the build

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
        if (root.contains("targets")) scene_.targets = read_targets(root.at("targets"));
        if (root.contains("cavity")) scene_.cavity = read_cavity(root.at("cavity"));
        if (root.contains("bowel")) {
            scene_.bowel = read_bowel_spec(document_, root.at("bowel"));
            check_tissue("/bowel", scene_.bowel->tissue);
        }
        if (root.contains("tethers")) scene_.tethers = read_tethers(root.at("tethers"));
        if (root.contains("membranes")) read_membranes(root.at("membranes"));
        if (root.contains("sheet")) scene_.sheet = read_sheet(root.at("sheet"));
        read_sacral_hollow(root);
        if (root.contains("bands")) read_bands(root.at("bands"));
        if (root.contains("structures")) read_structures(root.at("structures"));
        if (root.contains("objects")) read_objects(root.at("objects"));
        read_camera_targets(document_, scene_);
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

    TargetFieldSpec read_targets(const json& node) {
        TargetFieldSpec targets;
        copy(node, "per_hand", targets.per_hand);
        copy(node, "radius", targets.radius);
        copy(node, "centre", targets.centre);
        copy(node, "half_extent", targets.half_extent);
        copy(node, "minimum_distance", targets.minimum_distance);
        copy(node, "tissue", targets.tissue);
        copy(node, "stiffness", targets.stiffness);
        copy(node, "damping", targets.damping);
        check_tissue("/targets", targets.tissue);
        if (targets.half_extent.minCoeff() <= 0 || targets.half_extent.maxCoeff() > 0.3) {
            document_.fail("/targets/half_extent",
                           QT_TRANSLATE_NOOP("errors", "the box has an edge of 0 or above 0.6 m"),
                           QT_TRANSLATE_NOOP("errors", "give three half edges in metres, each above 0"));
        }
        // Random packing of spheres of half the distance succeeds for fill ratios well below 0.2; above that
        // it may never end.
        const double box = 8 * targets.half_extent.prod();
        const double filled = 2 * targets.per_hand * 0.5236 * std::pow(targets.minimum_distance, 3);
        if (filled > 0.32 * box) {
            document_.fail(
                "/targets/per_hand",
                QT_TRANSLATE_NOOP("errors", "the box has no room for this many targets at this distance"),
                QT_TRANSLATE_NOOP("errors",
                                  "give fewer targets, a smaller minimum_distance or a larger half_extent"));
        }
        return targets;
    }

    CavitySpec read_cavity(const json& node) {
        CavitySpec cavity;
        copy(node, "pelvis_width", cavity.pelvis_width);
        copy(node, "pelvis_depth", cavity.pelvis_depth);
        copy(node, "seed", cavity.seed);
        copy(node, "tissue", cavity.tissue);
        check_tissue("/cavity", cavity.tissue);
        return cavity;
    }

    TetherSpec read_tethers(const json& node) {
        TetherSpec tethers;
        copy(node, "count", tethers.count);
        copy(node, "first", tethers.first);
        copy(node, "last", tethers.last);
        copy(node, "stiffness", tethers.stiffness);
        copy(node, "damping", tethers.damping);
        copy(node, "slack", tethers.slack);
        if (!document_.root().contains("bowel")) {
            document_.fail("/tethers", QT_TRANSLATE_NOOP("errors", "tethers need a bowel"),
                           QT_TRANSLATE_NOOP("errors", "add a \"bowel\" or remove \"tethers\""));
        }
        if (tethers.first >= tethers.last) {
            document_.fail("/tethers/first", QT_TRANSLATE_NOOP("errors", "first must be below last"),
                           QT_TRANSLATE_NOOP("errors", "give first < last, fractions of the bowel's length"));
        }
        return tethers;
    }

    void read_membranes(const json& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const json& node = list[i];
            MembraneSpec membrane;
            copy(node, "kind", membrane.kind);
            copy(node, "first", membrane.first);
            copy(node, "last", membrane.last);
            copy(node, "structural_stiffness", membrane.structural_stiffness);
            copy(node, "shear_stiffness", membrane.shear_stiffness);
            copy(node, "bend_stiffness", membrane.bend_stiffness);
            copy(node, "surface_density", membrane.surface_density);
            copy(node, "pre_strain", membrane.pre_strain);
            copy(node, "stiffness_damping", membrane.stiffness_damping);
            copy(node, "mass_damping", membrane.mass_damping);
            copy(node, "weight", membrane.weight);
            const std::string place = "/membranes/" + std::to_string(i);
            if (!scene_.bowel || !scene_.cavity) {
                document_.fail(
                    place, QT_TRANSLATE_NOOP("errors", "a membrane needs a bowel and a cavity to attach to"),
                    QT_TRANSLATE_NOOP("errors", "add \"bowel\" and \"cavity\" or remove \"membranes\""));
            }
            if (membrane.first >= membrane.last) {
                document_.fail(
                    place + "/first", QT_TRANSLATE_NOOP("errors", "first must be below last"),
                    QT_TRANSLATE_NOOP("errors", "give first < last, fractions of the bowel's length"));
            }
            scene_.membranes.push_back(membrane);
        }
    }

    SheetSpec read_sheet(const json& node) {
        SheetSpec sheet;
        copy(node, "kind", sheet.kind);
        copy(node, "tissue", sheet.tissue);
        copy(node, "centre", sheet.centre);
        copy(node, "along", sheet.along);
        copy(node, "across", sheet.across);
        copy(node, "length", sheet.length);
        copy(node, "width", sheet.width);
        copy(node, "spacing", sheet.spacing);
        copy(node, "thickness", sheet.thickness);
        sheet.line_length = std::min(sheet.line_length, sheet.length);
        copy(node, "line_length", sheet.line_length);
        copy(node, "line_at", sheet.line_at);
        copy(node, "flap_stiffness", sheet.flap_stiffness);
        copy(node, "structural_stiffness", sheet.structural_stiffness);
        copy(node, "shear_stiffness", sheet.shear_stiffness);
        copy(node, "bend_stiffness", sheet.bend_stiffness);
        copy(node, "surface_density", sheet.surface_density);
        copy(node, "pre_strain", sheet.pre_strain);
        copy(node, "stiffness_damping", sheet.stiffness_damping);
        copy(node, "mass_damping", sheet.mass_damping);
        copy(node, "weight", sheet.weight);
        copy(node, "blade_width", sheet.blade_width);
        copy(node, "fibres", sheet.fibres);
        check_tissue("/sheet", sheet.tissue);
        for (Vector3* direction : {&sheet.along, &sheet.across}) {
            if (direction->norm() < 1e-6) {
                document_.fail(direction == &sheet.along ? "/sheet/along" : "/sheet/across",
                               QT_TRANSLATE_NOOP("errors", "the direction has no length"),
                               QT_TRANSLATE_NOOP("errors", "give a vector in the sheet's plane"));
            }
            direction->normalize();
        }
        sheet.across -= sheet.along * sheet.along.dot(sheet.across);
        if (sheet.across.norm() < 0.1) {
            document_.fail("/sheet/across",
                           QT_TRANSLATE_NOOP("errors", "across is parallel to the marked line"),
                           QT_TRANSLATE_NOOP("errors", "give a direction at right angles to \"along\""));
        }
        sheet.across.normalize();
        if (sheet.line_length > sheet.length) {
            document_.fail("/sheet/line_length",
                           QT_TRANSLATE_NOOP("errors", "the marked line is longer than the sheet"),
                           QT_TRANSLATE_NOOP("errors", "give at most length"));
        }
        if (sheet.spacing > 0.25 * std::min(sheet.length, sheet.width) ||
            sheet.length / sheet.spacing * (sheet.width / sheet.spacing) > 20000) {
            document_.fail("/sheet/spacing",
                           QT_TRANSLATE_NOOP("errors",
                                             "the sheet would have fewer than five vertices along an edge, "
                                             "or more than 20000 in total"),
                           QT_TRANSLATE_NOOP("errors", "give a spacing that suits length and width"));
        }
        return sheet;
    }

    void read_sacral_hollow(const json& root) {
        const bool rectum = scene_.bowel && scene_.bowel->layout == BowelLayout::rectum;
        if (root.contains("presacral")) {
            if (!scene_.bowel)
                document_.fail("/presacral", QT_TRANSLATE_NOOP("errors", "a presacral wall needs a rectum"),
                               QT_TRANSLATE_NOOP("errors", "add a bowel of layout \"rectum\""));
            scene_.presacral = read_presacral_spec(document_, root.at("presacral"), scene_.bowel->length);
            check_tissue("/presacral", scene_.presacral->tissue);
        }
        if (rectum != scene_.presacral.has_value()) {
            document_.fail(
                rectum ? "/bowel/layout" : "/presacral",
                QT_TRANSLATE_NOOP("errors", "a rectum and a presacral wall need each other"),
                QT_TRANSLATE_NOOP(
                    "errors",
                    "give the bowel the layout \"rectum\" and the scene \"presacral\", or neither"));
        }
        if (rectum && (scene_.cavity || scene_.tethers || !scene_.membranes.empty() || scene_.targets)) {
            document_.fail(
                "/presacral",
                QT_TRANSLATE_NOOP(
                    "errors",
                    "a scene with a presacral wall cannot have a cavity, tethers, membranes or targets"),
                QT_TRANSLATE_NOOP("errors", "remove cavity, tethers, membranes and targets"));
        }
        if (!root.contains("septa")) return;
        if (!rectum || scene_.sheet) {
            document_.fail(
                "/septa",
                QT_TRANSLATE_NOOP("errors", "septa need a rectum and a presacral wall, and exclude a sheet"),
                QT_TRANSLATE_NOOP(
                    "errors", "add \"presacral\" and a bowel of layout \"rectum\", and remove \"sheet\""));
        }
        scene_.septa = read_septa_spec(document_, root.at("septa"), *scene_.presacral, scene_.bowel->length,
                                       scene_.bowel->outer_radius);
        check_tissue("/septa", scene_.septa->tissue);
        check_tissue("/septa", scene_.septa->fat_tissue);
    }

    void read_bands(const json& node) {
        scene_.bands = read_bands_spec(document_, node);
        for (const std::string& label : {scene_.bands->tissue, scene_.bands->bed_tissue,
                                         scene_.bands->nerve_tissue, scene_.bands->vessel_tissue}) {
            check_tissue("/bands", label);
        }
        if (scene_.bowel || scene_.cavity || scene_.targets || scene_.sheet) {
            document_.fail("/bands",
                           QT_TRANSLATE_NOOP(
                               "errors", "bands cannot be combined with a bowel, cavity, sheet or targets"),
                           QT_TRANSLATE_NOOP("errors", "remove those parts or \"bands\""));
        }
    }

    void read_structures(const json& node) {
        scene_.structures = read_structures_spec(document_, node);
        for (const std::string& label : {scene_.structures->bed_tissue, scene_.structures->nerve_tissue,
                                         scene_.structures->vessel_tissue}) {
            check_tissue("/structures", label);
        }
        if (!scene_.presacral) {
            document_.fail("/structures", QT_TRANSLATE_NOOP("errors", "structures need a presacral wall"),
                           QT_TRANSLATE_NOOP("errors", "add \"presacral\" or remove \"structures\""));
        }
        if (scene_.bands) {
            document_.fail("/structures",
                           QT_TRANSLATE_NOOP("errors", "bands and structures cannot be combined"),
                           QT_TRANSLATE_NOOP("errors", "remove \"bands\" or \"structures\""));
        }
    }

    void read_objects(const json& node) {
        scene_.objects = read_objects_spec(document_, node);
        for (const std::string& label : {scene_.objects->tissue, scene_.objects->tray_tissue})
            check_tissue("/objects", label);
        if (scene_.bowel || scene_.cavity || scene_.targets || scene_.sheet || scene_.bands ||
            scene_.presacral) {
            document_.fail(
                "/objects",
                QT_TRANSLATE_NOOP("errors",
                                  "objects on a tray cannot be combined with tissue, cavity or targets"),
                QT_TRANSLATE_NOOP("errors", "remove those parts or \"objects\""));
        }
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

    void check_tissue(const std::string& place, const std::string& label) {
        if (scene_.tissue_index(label) >= 0) return;
        std::string known;
        for (const TissueSpec& tissue : scene_.tissues) known += (known.empty() ? "" : ", ") + tissue.label;
        document_.fail(
            place + "/tissue",
            {QT_TRANSLATE_NOOP("errors", "the tissue \"%1\" is not in the list of tissues"), label},
            {QT_TRANSLATE_NOOP("errors", "use one of: %1, or add it to \"tissues\""), known});
    }

    const JsonDocument& document_;
    Scene scene_;
};

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file) {
    const JsonDocument document = JsonDocument::parse(text, file);
    document.check_schema(scene_schema_text);
    return SceneReader(document).read();
}

Scene load_scene(const std::string& path) {
    return parse_scene(read_text_file(path, JsonLimits().bytes), path);
}

}  // namespace fulcrum
