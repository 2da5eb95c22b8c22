// SPDX-License-Identifier: Apache-2.0
// Cuts for the tests of a cuttable membrane, made without a mesh of visible triangles.
#pragma once

#include <algorithm>
#include <functional>
#include <map>

#include "sim_core/lab/membrane_reference.h"
#include "sim_core/membrane/cut_membrane.h"
#include "sim_core/numerics/random.h"

namespace fulcrum::test {

/// A cut of an uncut sheet along the line x = place, with the given kerf, through the triangles that
/// `through` selects. New pieces are numbered from free_slot on.
inline MembraneCut straight_cut(const CutMembrane& membrane, std::int32_t free_slot, double place,
                                double kerf, const std::function<bool(const Triangle&)>& through) {
    const auto& rest = membrane.rest();
    const auto& triangles = membrane.triangles();
    // Length or area share of the part left (side 0) or right (side 1) of the kerf.
    const auto edge_share = [&](std::int32_t a, std::int32_t b, int side) {
        const double sign = side == 0 ? -1 : 1;
        const double da = sign * (rest[static_cast<std::size_t>(a)].x() - place) - 0.5 * kerf;
        const double db = sign * (rest[static_cast<std::size_t>(b)].x() - place) - 0.5 * kerf;
        if (da > 0 && db > 0) return 1.0;
        if (da <= 0 && db <= 0) return 0.0;
        return std::max(da, db) / (std::max(da, db) - std::min(da, db));
    };
    const auto area_share = [&](const Triangle& t, int side) {
        const double sign = side == 0 ? -1 : 1;
        double d[3];
        int in = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            d[c] = sign * (rest[static_cast<std::size_t>(t[c])].x() - place) - 0.5 * kerf;
            in += d[c] > 0 ? 1 : 0;
        }
        if (in == 0) return 0.0;
        if (in == 3) return 1.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = d[c], b = d[(c + 1) % 3], e = d[(c + 2) % 3];
            if (in == 1 && a > 0) return a / (a - b) * a / (a - e);
            if (in == 2 && a <= 0) return 1 - a / (a - b) * a / (a - e);
        }
        return 0.0;
    };
    MembraneCut cut;
    std::map<std::int32_t, std::array<std::int32_t, 2>> named;  // piece of each side, -1 none
    for (std::size_t r = 0; r < triangles.size(); ++r) {
        double least = 1e9, most = -1e9;
        for (const std::int32_t v : triangles[r]) {
            least = std::min(least, rest[static_cast<std::size_t>(v)].x());
            most = std::max(most, rest[static_cast<std::size_t>(v)].x());
        }
        if (!through(triangles[r]) || most <= place - 0.5 * kerf || least >= place + 0.5 * kerf) continue;
        const auto root = static_cast<std::int32_t>(r);
        cut.roots.push_back(root);
        named[root] = {-1, -1};
        bool first = true;
        for (int side = 0; side < 2; ++side) {
            MembranePiece piece;
            piece.root = root;
            piece.from = root;
            piece.share = area_share(triangles[r], side);
            if (!(piece.share > 1e-12)) continue;
            for (int c = 0; c < 3; ++c) {
                const std::int32_t a = triangles[r][static_cast<std::size_t>(c)],
                                   b = triangles[r][static_cast<std::size_t>((c + 1) % 3)];
                if (edge_share(a, a, side) > 0)
                    piece.corners = static_cast<std::uint8_t>(piece.corners | 1 << c);
                if (edge_share(a, b, side) > 0) piece.edges = static_cast<std::uint8_t>(piece.edges | 1 << c);
            }
            piece.slot = first ? root : free_slot++;
            first = false;
            named[root][static_cast<std::size_t>(side)] = piece.slot;
            cut.pieces.push_back(piece);
        }
    }
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::pair<std::int32_t, int>>> edges;
    for (std::size_t r = 0; r < triangles.size(); ++r) {
        for (int e = 0; e < 3; ++e) {
            const std::int32_t a = triangles[r][static_cast<std::size_t>(e)],
                               b = triangles[r][static_cast<std::size_t>((e + 1) % 3)];
            edges[{std::min(a, b), std::max(a, b)}].emplace_back(static_cast<std::int32_t>(r), e);
        }
    }
    for (const auto& [ends, sides] : edges) {
        if (sides.size() != 2) continue;
        const bool cut_first = named.count(sides[0].first) != 0,
                   cut_second = named.count(sides[1].first) != 0;
        if (!cut_first && !cut_second) continue;
        for (int side = 0; side < 2; ++side) {
            PieceContact contact;
            contact.first =
                cut_first ? named[sides[0].first][static_cast<std::size_t>(side)] : sides[0].first;
            contact.second =
                cut_second ? named[sides[1].first][static_cast<std::size_t>(side)] : sides[1].first;
            if ((cut_first && contact.first < 0) || (cut_second && contact.second < 0)) continue;
            contact.edge = sides[0].second;
            contact.share = edge_share(ends.first, ends.second, side);
            if (contact.share > 0) cut.contacts.push_back(contact);
        }
    }
    return cut;
}

/// An arbitrary cut, not necessarily geometric: each piece of some roots is divided into up to three parts,
/// some of them thin; some area is lost, and contacts may be lost.
inline MembraneCut random_cut(const CutMembrane& membrane, const CutMembraneState& state, Random& random) {
    MembraneCut cut;
    const auto roots = static_cast<std::int32_t>(membrane.triangles().size());
    std::vector<std::uint8_t> touched(static_cast<std::size_t>(roots), 0);
    std::map<std::int32_t, std::vector<std::int32_t>> heirs;  // of an old piece
    std::int32_t free_slot = 0;
    for (std::size_t p = 0; p < state.pieces.size(); ++p) {
        if (state.pieces[p].root >= 0) free_slot = static_cast<std::int32_t>(p) + 1;
    }
    for (int i = 0; i < 4; ++i) {
        const auto root = static_cast<std::int32_t>(random.uniform() * roots);
        if (root >= roots || touched[static_cast<std::size_t>(root)]++ != 0) continue;
        cut.roots.push_back(root);
        for (std::int32_t p = state.first_piece[static_cast<std::size_t>(root)]; p >= 0;
             p = state.pieces[static_cast<std::size_t>(p)].next) {
            const int parts = static_cast<int>(random.uniform() * 4);
            double left = state.pieces[static_cast<std::size_t>(p)].share * (1 - 0.05 * random.uniform());
            for (int k = 0; k < parts; ++k) {
                MembranePiece piece;
                piece.root = root;
                piece.from = p;
                piece.share =
                    k + 1 == parts ? left : left * (random.uniform() < 0.3 ? 1e-9 : random.uniform());
                left -= piece.share;
                if (!(piece.share > 1e-15)) continue;
                const auto kept = static_cast<int>(random.uniform() * 8);  // no more than it was a part of
                piece.corners =
                    static_cast<std::uint8_t>(state.pieces[static_cast<std::size_t>(p)].corners & kept);
                piece.edges =
                    static_cast<std::uint8_t>(state.pieces[static_cast<std::size_t>(p)].edges & kept);
                piece.slot = heirs[p].empty() ? p : free_slot++;
                heirs[p].push_back(piece.slot);
                cut.pieces.push_back(piece);
            }
        }
    }
    // Most of the previous contacts continue between the new parts.
    for (std::size_t e = 0; e < state.first_contact.size(); ++e) {
        for (std::int32_t c = state.first_contact[e]; c >= 0;
             c = state.contacts[static_cast<std::size_t>(c)].next) {
            const auto& contact = state.contacts[static_cast<std::size_t>(c)];
            const auto& first = state.pieces[static_cast<std::size_t>(contact.first)];
            const auto& second = state.pieces[static_cast<std::size_t>(contact.second)];
            const bool cut_first = touched[static_cast<std::size_t>(first.root)] != 0,
                       cut_second = touched[static_cast<std::size_t>(second.root)] != 0;
            if (!cut_first && !cut_second) continue;
            const std::vector<std::int32_t> a = cut_first ? heirs[contact.first] : std::vector{contact.first};
            const std::vector<std::int32_t> b =
                cut_second ? heirs[contact.second] : std::vector{contact.second};
            // The edge in the first's root: the one whose two vertices are also in the other root.
            const Triangle &ta = membrane.triangles()[static_cast<std::size_t>(first.root)],
                           &tb = membrane.triangles()[static_cast<std::size_t>(second.root)];
            int edge = 0;
            for (int k = 0; k < 3; ++k) {
                const auto in = [&](std::int32_t v) {
                    return std::find(tb.begin(), tb.end(), v) != tb.end();
                };
                if (in(ta[static_cast<std::size_t>(k)]) && in(ta[static_cast<std::size_t>((k + 1) % 3)]))
                    edge = k;
            }
            double left = contact.share;
            for (const std::int32_t i : a) {
                for (const std::int32_t j : b) {
                    if (random.uniform() < 0.4) continue;
                    const double share = left * random.uniform();
                    left -= share;
                    if (share > 0) cut.contacts.push_back({i, j, edge, share});
                }
            }
        }
    }
    return cut;
}

}  // namespace fulcrum::test
