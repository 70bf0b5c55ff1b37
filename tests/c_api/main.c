/* The C interface, compiled as C: its results are those of `glint eval`, its errors one line each. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "glint.h"

#define EXPECTED 1448u /* n = 50, C = 256901: an example of docs/lobes/bps.md */

static int failures;

static void check(int good, const char *what, int line) {
    if (good) return;
    printf("main.c:%d: FAILED: %s; last error: %s\n", line, what, glint_error());
    ++failures;
}
#define CHECK(condition) check((condition), #condition, __LINE__)

/* After a call that failed: one line that holds the text. */
static void refused(int failed, const char *text, int line) {
    check(failed, "refused", line);
    check(strstr(glint_error(), text) != NULL && strchr(glint_error(), '\n') == NULL, text, line);
}
#define REFUSED(call, text) refused((call), text, __LINE__)

static void lobes(void) {
    glint_model *bps = glint_open_lobe("bps", "p12");
    glint_port port;
    uint32_t y = 0, results[3] = {7, 7, 7};
    int32_t clamped = 7;
    const uint16_t n[3] = {50, 0, 1023}, wrong_n[3] = {50, 0, 1024};
    const int32_t cosines[3] = {256901, -5, 262145};
    CHECK(bps != NULL);
    CHECK(glint_input_count(bps) == 2 && glint_output_count(bps) == 1);
    CHECK(glint_input(bps, 1, &port) == 0 && strcmp(port.name, "cos_code") == 0 && port.bits == 20 && port.is_signed == 1 &&
          port.fraction_bits == 18 && port.low == 0 && port.high == 262144);
    CHECK(glint_output(bps, 0, &port) == 0 && strcmp(port.name, "y") == 0 && port.bits == 13 && port.high == 4096);
    REFUSED(glint_input(bps, 2, &port) == -1, "index 2");
    CHECK(glint_eval(bps, 50, 256901, &y) == 0 && y == EXPECTED);
    CHECK(glint_eval_port(bps, 50, 256901, &y, &clamped) == 0 && y == EXPECTED && clamped == 0);
    CHECK(glint_eval_port(bps, 0, -5, &y, &clamped) == 0 && y == 0 && clamped == 1);
    REFUSED(glint_eval(bps, 0, 5, &y) == -1, "n 0 is not legal");
    REFUSED(glint_eval(bps, 5, 262145, &y) == -1, "262145");
    REFUSED(glint_eval(bps, 5, 5, NULL) == -1, "y is not legal: NULL");
    REFUSED(glint_eval_port_batch(bps, 3, wrong_n, cosines, results) == -1, "n[2] 1024 is not legal: 0 to 1023");
    CHECK(results[0] == 7 && results[2] == 7);
    CHECK(glint_eval_port_batch(bps, 3, n, cosines, results) == 0);
    CHECK(results[0] == EXPECTED && results[1] == 0x80000000u);
    CHECK(glint_eval_port(bps, 1023, 262145, &y, &clamped) == 0 && clamped == 1 && results[2] == (y | 0x80000000u));
    CHECK(glint_eval_port_batch(bps, 0, NULL, NULL, NULL) == 0);
    REFUSED(glint_effect_eval_port(bps, NULL, NULL, NULL) == -1, "a lobe, where an effect is wanted");
    glint_close(bps);
}

static void effects(void) {
    glint_model *lambert = glint_open_effect("lambert", "p8", NULL);
    size_t inputs = glint_input_count(lambert), outputs = glint_output_count(lambert), i;
    int64_t *in = calloc(inputs, sizeof *in), *out = calloc(outputs, sizeof *out);
    int32_t clamped = 7, value = 0, result = 0;
    uint8_t flag = 7;
    uint32_t y;
    const int32_t *columns[8];
    int32_t *results[8];
    glint_port port;
    CHECK(lambert != NULL && inputs >= 1 && inputs <= 8 && outputs == 1);
    for (i = 0; i < inputs; ++i) {
        CHECK(glint_input(lambert, i, &port) == 0);
        in[i] = port.high;
    }
    CHECK(glint_effect_eval_port(lambert, in, out, &clamped) == 0 && clamped == 0 && out[0] > 0);
    value = (int32_t)in[0];
    columns[0] = &value;
    results[0] = &result;
    CHECK(inputs == 1);
    CHECK(glint_effect_eval_port_batch(lambert, 1, columns, results, &flag) == 0 && result == out[0] && flag == 0);
    value = INT32_MAX;
    REFUSED(glint_effect_eval_port_batch(lambert, 1, columns, results, &flag) == -1, "[0] 2147483647 is not legal");
    in[0] = -1;
    CHECK(glint_effect_eval_port(lambert, in, out, &clamped) == 0 && clamped == 0 && out[0] == 0);
    in[0] = INT64_MAX;
    REFUSED(glint_effect_eval_port(lambert, in, out, &clamped) == -1, "9223372036854775807");
    REFUSED(glint_eval(lambert, 1, 1, &y) == -1, "an effect, where a lobe is wanted");
    free(in);
    free(out);
    glint_close(lambert);
}

int main(void) {
    CHECK(strcmp(glint_error(), "") == 0);
    CHECK(strcmp(glint_version(), VERSION) == 0);
    REFUSED(glint_open_lobe("phong", "p12") == NULL, "'phong'");
    REFUSED(glint_open_lobe("bps", "p13") == NULL, "p13");
    REFUSED(glint_open_lobe(NULL, "p12") == NULL, "lobe is not legal: NULL");
    REFUSED(glint_open_effect("shade", "p12", "none") == NULL, "'none'");
    REFUSED(glint_eval(NULL, 1, 1, NULL) == -1, "NULL");
    glint_close(NULL);
    lobes();
    effects();
    printf("%d failures\n", failures);
    return failures == 0 ? 0 : 1;
}
