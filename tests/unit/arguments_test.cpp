#include "catch.hpp"
#include "glint/range.hpp"
#include "io/command.hpp"
#include "io/json_node.hpp"
#include "refusal.hpp"

// What arguments and fields of files may be, at both ends.
using namespace glint;
using namespace glint::io;

TEST_CASE("shards: the first, the last, and no more parts than tasks") {
    CHECK(parse_shard("1/1") == Shard{1, 1});
    CHECK(parse_shard("16/16") == Shard{16, 16});
    CHECK(parse_shard("1/1000000") == Shard{1, 1'000'000});
    for (const char* wrong : {"0/4", "5/4", "1/1000001", "1", "1/", "/4", "a/4", "1/4a", ""}) {
        CHECK(refusal([&] { parse_shard(wrong); }) ==
              std::string("--shard '") + wrong + "' is not legal: i/N with 1 <= i <= N <= 1000000");
    }
    CHECK_NOTHROW(Shard{2, 7}.check(7));
    CHECK(refusal([] { Shard{2, 8}.check(7); }) == "--shard 2/8 is not legal: this run has 7 parts at most");
}

TEST_CASE("lists: an entry that is missing is an empty one") {
    CHECK(split_list("a,b") == std::vector<std::string>{"a", "b"});
    CHECK(split_list("") == std::vector<std::string>{""});
    CHECK(split_list("a,") == std::vector<std::string>{"a", ""});
}

TEST_CASE("JSON: numbers that are none, lists of another length, and how a refusal shows them") {
    const nlohmann::json json{{"text", "1"},
                              {"less", -0.5},
                              {"none", 0},
                              {"list", {1U, 2U}},
                              {"real", {0.5}},
                              {"large", {4294967296U}},
                              {"forty", std::string(38, 'a')},
                              {"more", std::string(39, 'a')}};
    const std::string file = "file";
    const JsonNode node(json, file);
    CHECK(node.number("none") == 0.0);
    CHECK(refusal([&] { node.number("text"); }) == "file: text \"1\" is not legal: a number, 0 or more");
    CHECK(refusal([&] { node.number("less"); }) == "file: less -0.5 is not legal: a number, 0 or more");
    CHECK(node.counts("list", 2) == std::vector<std::uint32_t>{1, 2});
    CHECK(refusal([&] { node.counts("list", 3); }) == "file: list [1,2] is not legal: a list of 3 whole numbers");
    CHECK(refusal([&] { node.counts("real", 1); }) == "file: real [0.5] is not legal: a list of 1 whole numbers");
    CHECK(refusal([&] { node.counts("large", 1); }) ==
          "file: large [4294967296] is not legal: a list of 1 whole numbers");
    // The quotes make them 40 and 41 characters.
    CHECK(refusal([&] { node.number("forty"); }) ==
          "file: forty \"" + std::string(38, 'a') + "\" is not legal: a number, 0 or more");
    CHECK(refusal([&] { node.number("more"); }) ==
          "file: more \"" + std::string(39, 'a') + "... is not legal: a number, 0 or more");
}
