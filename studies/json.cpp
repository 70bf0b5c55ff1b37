#include "studies/json.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace glint::studies {
namespace {

using Json = nlohmann::ordered_json;

/// With seven digits; what is not known is null.
Json rounded(double x) { return std::isnan(x) ? Json() : Json(std::strtod(fmt::format("{:.7g}", x).c_str(), nullptr)); }

template <class Items, class Value>
Json column(const Items& items, const Value& value) {
    Json out = Json::array();
    for (const auto& item : items) out.push_back(rounded(value(item)));
    return out;
}

Json column(const std::vector<double>& values) {
    return column(values, [](double x) { return x; });
}

Json to_json(const AngleError& error) { return {{"value", rounded(error.value)}, {"degrees", rounded(error.degrees)}}; }

Json curves_json() {
    const Curves c = curves(shape_n);
    using Point = Curves::Point;
    return {{"n", c.n},
            {"worst", {{"schlick", to_json(c.schlick)}, {"bps", to_json(c.bps)}}},
            {"degrees", column(c.points, [](const Point& p) { return p.degrees; })},
            {"blinn_phong", column(c.points, [](const Point& p) { return p.blinn_phong; })},
            {"schlick", column(c.points, [](const Point& p) { return p.schlick; })},
            {"bps", column(c.points, [](const Point& p) { return p.bps; })}};
}

Json schlick_json() {
    const std::vector<AngleError> errors = schlick_errors();
    const auto worst = std::max_element(errors.begin(), errors.end(),
                                        [](const AngleError& a, const AngleError& b) { return a.value < b.value; });
    Json at = to_json(*worst);
    at["n"] = worst - errors.begin() + 1;
    return {{"inputs", static_cast<std::size_t>(angles) * errors.size()},
            {"worst", std::move(at)},
            {"largest", column(errors, [](const AngleError& e) { return e.value; })}};
}

Json map_json() {
    const ErrorMap map = error_map("p12");
    return {{"profile", map.profile.name},
            {"F", map.profile.F},
            {"last_n", max_n},
            {"columns", map.columns},
            {"rows", map.rows},
            {"inputs", map.inputs},
            {"worst", {{"value", rounded(map.worst.value)}, {"n", map.worst.n}, {"cos_code", map.worst.cos_code}}},
            {"error", column(map.error)}};
}

Json to_json(const Surface& s) {
    return {{"columns", s.columns},
            {"rows", s.rows},
            {"largest", rounded(s.largest)},
            {"largest_n", rounded(s.largest_n)},
            {"largest_theta", rounded(s.largest_theta)},
            {"n", column(s.n)},
            {"theta", column(s.theta)},
            {"value", column(s.value)}};
}

Json to_json(const Operations& o) {
    return {{"multiplications", o.multiplications}, {"divisions", o.divisions},     {"additions", o.additions},
            {"increments", o.increments},           {"comparisons", o.comparisons}, {"calls", o.calls}};
}

Json to_json(const Operations::Latencies& l) {
    return {{"multiplication", l.multiplication},
            {"division", l.division},
            {"addition", l.addition},
            {"increment", l.increment},
            {"comparison", l.comparison}};
}

/// Of a library's calls no sum is known.
Json cycles(const Operations& o, const Operations::Latencies& l) { return o.calls == 0 ? Json(o.cycles(l)) : Json(); }

const paper::TableRow* table_row(std::string_view lobe) {
    const auto rows = paper::table_1();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.lobe == lobe; });
    return found == rows.end() ? nullptr : &*found;
}

/// "kv" for f_kv; empty for lobes that are not the paper's.
std::string symbol(std::string_view lobe) {
    const paper::TableRow* row = table_row(lobe);
    return row == nullptr ? std::string() : std::string(row->symbol.substr(2));
}

/// The least n from which on delta stays within a tenth of its median; null where there is none.
Json settles(const Study& study, double median) {
    int out = 0;
    for (const StudyRow& row : study.rows) {
        if (row.n < paper::first_n) continue;
        if (row.delta.value > 1.1 * median) {
            out = 0;
        } else if (out == 0) {
            out = row.n;
        }
    }
    return out == 0 ? Json() : Json(out);
}

Json summary_json(const Summary& s, Json by_n) {
    return {{"largest", rounded(s.largest)}, {"n", s.n}, {"median", rounded(s.median)}, {"by_n", std::move(by_n)}};
}

Json to_json(const StudiedLobe& lobe, bool of_paper) {
    const Study& study = lobe.study;
    const Summary delta = study.delta(paper::first_n, paper::last_n);
    const auto all = forms();
    const auto form = std::find_if(all.begin(), all.end(), [&](const Form& f) { return f.lobe == lobe.lobe->name; });
    Json absolute = summary_json(study.absolute(paper::first_n, paper::last_n),
                                 column(study.rows, [](const StudyRow& row) { return row.absolute.value; }));
    absolute["below"] = rounded(study.absolute(1, paper::first_n - 1).largest);
    Json out{{"name", lobe.lobe->name},
             {"symbol", symbol(lobe.lobe->name)},
             {"of_paper", of_paper},
             {"exact", lobe.exact()},
             {"peak", rounded(lobe.peak)},
             {"floor", rounded(lobe.floor)},
             {"zero", nullptr},
             {"cycles", form == all.end() ? Json() : cycles(form->count(), zen4_double)},
             {"settles", settles(study, delta.median)},
             {"delta", summary_json(delta, column(study.rows, [](const StudyRow& row) { return row.delta.value; }))},
             {"absolute", std::move(absolute)}};
    if (lobe.zero) {
        out["zero"] = {
            {"from", rounded(lobe.zero->from)}, {"to", rounded(lobe.zero->to)}, {"drop", rounded(lobe.zero->drop)}};
    }
    return out;
}

Json paper_1_json(const Findings& findings) {
    const auto latencies = paper::latencies_of_table_1(30);
    Json out{{"first_n", paper::first_n},
             {"last_n", paper::last_n},
             {"step", paper_step},
             {"time_tolerance", time_tolerance},
             {"zen4_double", to_json(zen4_double)},
             {"latencies", Json::array()},
             {"claims", to_json(findings.claims_1)},
             {"forms", Json::array()}};
    for (const auto& l : latencies) out["latencies"].push_back(to_json(l));
    for (const Form& form : forms()) {
        const Operations counted = form.count();
        const paper::TableRow* row = form.name == form.lobe ? table_row(form.lobe) : nullptr;
        Json entry{{"name", form.name},
                   {"lobe", form.lobe},
                   {"symbol", symbol(form.lobe)},
                   {"formula", form.formula},
                   {"operations", to_json(counted)},
                   {"cycles", cycles(counted, zen4_double)},
                   {"cycles_same_sum", latencies.size() == 1 ? cycles(counted, latencies.front()) : Json()},
                   {"printed", nullptr}};
        if (row != nullptr) entry["printed"] = {{"operations", to_json(row->operations)}, {"cycles", row->cycles}};
        out["forms"].push_back(std::move(entry));
    }
    return out;
}

Json models_json(const Paper2Data& data) {
    const paper2::TableRow& full = *paper2::printed("Cook-Torrance");
    Json out = Json::array();
    for (const auto& model : data.models) {
        const paper2::TableRow* row = paper2::printed(model.model);
        Json entry{{"name", model.name},
                   {"model", model.model},
                   {"form", model.form},
                   {"total", paper2::total(model.operations)},
                   {"operations", to_json(model.operations)},
                   {"printed", nullptr},
                   {"instructions_of_full", nullptr},
                   {"time_of_full", nullptr}};
        if (row != nullptr) {
            entry["printed"] = {{"instructions", row->instructions}, {"pixels_per_second", row->pixels_per_second}};
            entry["instructions_of_full"] = rounded(static_cast<double>(row->instructions) / full.instructions);
            entry["time_of_full"] = rounded(full.pixels_per_second / row->pixels_per_second);
        } else if (model.model == "modified Cook-Torrance") {
            entry["instructions_of_full"] =
                rounded(static_cast<double>(paper2::printed_modified_instructions) / full.instructions);
            entry["time_of_full"] = rounded(1.0 / paper2::printed_speedup);
        }
        out.push_back(std::move(entry));
    }
    return out;
}

Json paper_2_json(const Findings& findings) {
    const Paper2Data& data = findings.paper_2;
    const paper2::HighlightFigure& h = data.highlight;
    Json out{{"claims", to_json(findings.claims_2)},
             {"processor_claims", to_json(findings.processor_claims_2)},
             {"models", models_json(data)},
             {"distributions", Json::array()},
             {"reflectances", Json::array()},
             {"highlight",
              {{"n", h.n},
               {"phong_width", rounded(h.phong_width)},
               {"blinn_phong_width", rounded(h.blinn_phong_width)},
               {"equal_width", rounded(h.equal_width)},
               {"largest", rounded(h.largest)},
               {"x", column(h.x)},
               {"phong", column(h.phong)},
               {"blinn_phong", column(h.blinn_phong)},
               {"blinn_phong_4n", column(h.blinn_phong_4n)}}},
             {"likeness", Json::array()}};
    for (const auto& d : data.distributions) {
        out["distributions"].push_back({{"m", d.m},
                                        {"x", column(d.x)},
                                        {"distribution", column(d.distribution)},
                                        {"angle_cubic", column(d.angle_cubic)},
                                        {"half_cubic", column(d.half_cubic)}});
    }
    for (const auto& r : data.reflectances) {
        out["reflectances"].push_back({{"index", r.index},
                                       {"mean", rounded(r.mean)},
                                       {"x", column(r.x)},
                                       {"reflectance", column(r.reflectance)}});
    }
    for (const auto& l : data.likeness) {
        out["likeness"].push_back({{"index", l.index},
                                   {"m", l.m},
                                   {"light", rounded(l.light)},
                                   {"largest", rounded(l.largest)},
                                   {"largest_angle", rounded(l.largest_angle)},
                                   {"rms", rounded(l.rms)}});
    }
    return out;
}

}  // namespace

Findings find(const Costs& formulas, const Costs& models) {
    Findings out;
    out.claims_1 = claims_of_paper_1(out.paper_1, formulas);
    out.claims_2 = claims_of_paper_2(out.paper_2);
    out.processor_claims_2 = processor_claims_of_paper_2(out.paper_2, models);
    return out;
}

Json to_json(const Findings& findings) {
    const PaperData& data = findings.paper_1;
    Json lobes = Json::array();
    for (const StudiedLobe& lobe : data.lobes) lobes.push_back(to_json(lobe, lobes.size() < data.of_paper));
    return {{"format", "glint-study-1"},
            {"tolerance", paper::tolerance},
            {"least_degrees", map_least_degrees},
            {"paper_1", paper_1_json(findings)},
            {"paper_2", paper_2_json(findings)},
            {"lobes", std::move(lobes)},
            {"curves", curves_json()},
            {"schlick", schlick_json()},
            {"map", map_json()},
            {"surfaces",
             {{"highlight", to_json(data.highlight)},
              {"delta", to_json(data.delta)},
              {"absolute", to_json(data.absolute)}}}};
}

}  // namespace glint::studies
