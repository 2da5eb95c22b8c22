// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/field_json.h"
#include "sim_core/scene/part_reading.h"
#include "sim_core/scene/scene_json.h"

namespace fulcrum {
namespace {

using nlohmann::json;

using scene_json::copy;
using scene_json::copy_degrees;

BandsSpec read_bands_spec(const JsonDocument& document, const json& node) {
    BandsSpec bands;
    copy(node, "count", bands.count);
    copy(node, "vessels", bands.vessels);
    copy(node, "centre", bands.centre);
    copy(node, "half_extent", bands.half_extent);
    copy(node, "height", bands.height);
    copy(node, "length", bands.length);
    copy(node, "width", bands.width);
    copy(node, "thickness", bands.thickness);
    copy(node, "jitter", bands.jitter);
    copy_degrees(node, "tilt_deg", bands.tilt);
    copy(node, "young_modulus", bands.young_modulus);
    copy(node, "pre_strain", bands.pre_strain);
    copy(node, "tear_force", bands.tear_force);
    copy(node, "nerve_gap", bands.nerve_gap);
    copy(node, "recoil_tension", bands.recoil_tension);
    copy(node, "least_recoil", bands.least_recoil);
    copy(node, "tissue", bands.tissue);
    scene_json::copy_field(node, bands);
    if (bands.vessels > bands.count) {
        document.fail("/bands/vessels", QT_TRANSLATE_NOOP("errors", "there are more vessels than bands"),
                      QT_TRANSLATE_NOOP("errors", "give at most \"count\""));
    }
    if (bands.half_extent.x() < bands.length + 2 * bands.jitter ||
        bands.half_extent.y() < 0.003 * bands.count) {
        document.fail("/bands/half_extent",
                      QT_TRANSLATE_NOOP("errors", "the bed is too small for two columns of such bands"),
                      QT_TRANSLATE_NOOP("errors", "give a wider bed, fewer bands or shorter ones"));
    }
    if (bands.half_extent.maxCoeff() > 0.3 || bands.half_extent.z() < 0) {
        document.fail(
            "/bands/half_extent",
            QT_TRANSLATE_NOOP("errors", "the bed is larger than 0.6 m or its rim is below its middle"),
            QT_TRANSLATE_NOOP("errors", "give half edges in metres"));
    }
    if (bands.nerve_gap >= bands.height) {
        document.fail("/bands/nerve_gap", QT_TRANSLATE_NOOP("errors", "the nerve is below the bed"),
                      QT_TRANSLATE_NOOP("errors", "give a gap below \"height\""));
    }
    return bands;
}

}  // namespace

void read_bands(const PartReading& reading, const nlohmann::json& node) {
    const BandsSpec bands = read_bands_spec(reading.document, node);
    for (const std::string& label :
         {bands.tissue, bands.bed_tissue, bands.nerve_tissue, bands.vessel_tissue}) {
        reading.check_tissue("/bands", label);
    }
    if (reading.scene.bowel || reading.scene.cavity || reading.scene.targets || reading.scene.sheet) {
        reading.document.fail(
            "/bands",
            QT_TRANSLATE_NOOP("errors", "bands cannot be combined with a bowel, cavity, sheet or targets"),
            QT_TRANSLATE_NOOP("errors", "remove those parts or \"bands\""));
    }
    reading.scene.bands = bands;
}

}  // namespace fulcrum
