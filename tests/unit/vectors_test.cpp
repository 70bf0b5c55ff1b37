#include "glint/vectors.hpp"

#include <sstream>

#include "catch.hpp"
#include "glint/error.hpp"
#include "glint/lobes.hpp"

using namespace glint;

TEST_CASE("the same seed gives the same vectors, another seed others") {
    const auto model = find_lobe("bps").golden(parse_profile("p12"));
    const std::string first = format_vectors(make_vectors(*model, 3000, 1), VectorFormat::tv);
    CHECK(first == format_vectors(make_vectors(*model, 3000, 1), VectorFormat::tv));
    CHECK(first != format_vectors(make_vectors(*model, 3000, 2), VectorFormat::tv));
}

TEST_CASE("the generator is SplitMix64") {
    Random random(1234567);  // the first outputs of its public reference for this seed
    CHECK(random.next() == 6457827717110365317ULL);
    CHECK(random.next() == 3203168211198807973ULL);
}

TEST_CASE("vectors start with the corners and hold legal and illegal inputs") {
    const auto model = find_lobe("bps").golden(parse_profile("p8"));
    const auto corners = corner_vectors(*model);
    const auto vectors = make_vectors(*model, 5000, 3);
    REQUIRE(vectors.size() == 5000);
    CHECK_THROWS_AS(make_vectors(*model, corners.size() - 1, 3), Error);
    CHECK(make_vectors(*model, corners.size(), 3).size() == corners.size());
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        if (i < corners.size()) CHECK(vectors[i].cos_code == corners[i].cos_code);
        CHECK(vectors[i].expected == model->eval_port(vectors[i].n, vectors[i].cos_code));
        clamped += vectors[i].expected.clamped ? 1 : 0;
    }
    CHECK(clamped > 100);
    CHECK(clamped < vectors.size() / 2);
}

TEST_CASE("the three formats say the same") {
    const auto model = find_lobe("bps").golden(parse_profile("p16"));
    const auto vectors = make_vectors(*model, 500, 5);
    std::istringstream tv(format_vectors(vectors, VectorFormat::tv));
    std::istringstream csv(format_vectors(vectors, VectorFormat::csv));
    std::istringstream hex(format_vectors(vectors, VectorFormat::hex));
    std::string line;
    std::getline(csv, line);
    CHECK(line == "n,cos_code,y,clamped");
    for (const TestVector& v : vectors) {
        long n = 0, code = 0, y = 0, clamped = 0;
        tv >> n >> code >> y >> clamped;
        CHECK((n == v.n && code == v.cos_code && y == v.expected.y && clamped == v.expected.clamped));
        char comma = 0;
        csv >> n >> comma >> code >> comma >> y >> comma >> clamped;
        CHECK((n == v.n && code == v.cos_code && y == v.expected.y && clamped == v.expected.clamped));
        hex >> line;
        REQUIRE(line.size() == 24);
        CHECK(static_cast<std::int32_t>(std::stoul(line.substr(0, 8), nullptr, 16)) == v.cos_code);
        CHECK(std::stoi(line.substr(8, 4), nullptr, 16) == v.n);
        CHECK(std::stoi(line.substr(12, 4), nullptr, 16) == (v.expected.clamped ? 1 : 0));
        CHECK(std::stoul(line.substr(16, 8), nullptr, 16) == v.expected.y);
    }
    CHECK_THROWS_AS(parse_vector_format("bin"), Error);
}

TEST_CASE("vectors of an effect start with its corners, the three formats say the same") {
    const Effect& effect = find_effect("tint");
    const auto model = effect.golden(parse_profile("p12"), "bps");
    const auto corners = corner_vectors(effect, *model, 3);
    CHECK_THROWS_AS(make_vectors(effect, *model, corners.size() - 1, 3), Error);
    const auto vectors = make_vectors(effect, *model, corners.size() + 2000, 3);
    std::istringstream tv(format_vectors(*model, vectors, VectorFormat::tv));
    std::istringstream csv(format_vectors(*model, vectors, VectorFormat::csv));
    std::istringstream hex(format_vectors(*model, vectors, VectorFormat::hex));
    std::string line;
    std::getline(csv, line);
    CHECK(line == "s,k_r,k_g,k_b,i_r,i_g,i_b,r,g,b,clamped");
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        const EffectVector& v = vectors[i];
        if (i < corners.size()) CHECK(v.in == corners[i].in);
        CHECK(v.expected == model->eval_port(v.in));
        clamped += v.expected.clamped ? 1 : 0;
        std::vector<std::int64_t> fields = v.in;
        fields.insert(fields.end(), v.expected.values.begin(), v.expected.values.end());
        fields.push_back(v.expected.clamped ? 1 : 0);
        std::getline(hex, line);
        REQUIRE(line.size() == 8 * fields.size());
        for (std::size_t f = 0; f < fields.size(); ++f) {
            std::int64_t value = -1;
            tv >> value;
            CHECK(value == fields[f]);
            csv >> value;
            CHECK(value == fields[f]);
            csv.get();  // comma or line feed
            CHECK(std::stoul(line.substr(8 * f, 8), nullptr, 16) == static_cast<std::uint32_t>(fields[f]));
        }
    }
    CHECK(clamped > 100);
    CHECK(clamped < vectors.size());
}
