/* The golden models from C: lobes and effects at a profile, bit for bit (docs/c-api.md).
 *
 * A model is immutable: threads may share it. Functions that can fail return NULL or -1; glint_error then says in one line
 * which argument, its value, and what is legal. What is passed as NULL where an object is wanted fails so, too;
 * NULL has 0 ports.
 */
#ifndef GLINT_H
#define GLINT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif
#ifdef __cplusplus
extern "C" {
#endif

typedef struct glint_model glint_model;

/* A port that carries a number. */
typedef struct {
    const char *name;      /* as in the contract; lives as long as the model */
    int32_t bits;          /* width, the sign included */
    int32_t is_signed;     /* 1: two's complement */
    int32_t fraction_bits; /* value = code / 2^fraction_bits */
    int64_t low, high;     /* legal codes; others are corrected and raise `clamped` */
} glint_port;

/* The version of the library, such as "0.1.0". */
const char *glint_version(void);

/* Why the last call of this thread that failed did so; "" before any did. Valid until the next failure. */
const char *glint_error(void);

/* A lobe by its name, "bps" or "polynomial:..." as on the command line, at a profile: "p8", "p12", "p16", or the numbers
 * of a custom one, "18,14,14,12". NULL: not legal. To be closed by glint_close. */
glint_model *glint_open_lobe(const char *lobe, const char *profile);

/* An effect. `lobe` is the lobe of phong, blinn_phong and shade; NULL is "bps", and other effects take no notice of it. */
glint_model *glint_open_effect(const char *effect, const char *profile, const char *lobe);

/* Frees a model; NULL is legal. */
void glint_close(glint_model *model);

/* The ports in the order of the arguments: a lobe has the inputs n and cos_code and the output y. */
size_t glint_input_count(const glint_model *model);
size_t glint_output_count(const glint_model *model);
int glint_input(const glint_model *model, size_t index, glint_port *port);
int glint_output(const glint_model *model, size_t index, glint_port *port);

/* y of a lobe for legal arguments: n in 1 .. 1023, cos_code in 0 .. 2^F. */
int glint_eval(const glint_model *model, int32_t n, int64_t cos_code, uint32_t *y);

/* What the ports of a lobe's unit show. Legal is what they can carry: n in 0 .. 1023, cos_code in -2^(F+1) .. 2^(F+1) - 1.
 * `clamped` is 1 where an argument was corrected. */
int glint_eval_port(const glint_model *model, int32_t n, int64_t cos_code, uint32_t *y, int32_t *clamped);

/* glint_eval_port for arrays, by the vector lanes of the machine: bits 30 .. 0 of a result are y, bit 31 is clamped.
 * Nothing is written when an argument is not legal. */
int glint_eval_port_batch(const glint_model *model, size_t count, const uint16_t *n, const int32_t *cos_code,
                          uint32_t *results);

/* What the ports of an effect's unit show: a code for each input port gives one for each output port. */
int glint_effect_eval_port(const glint_model *model, const int64_t *in, int64_t *out, int32_t *clamped);

/* The same for columns: in[p][i] is the code at port p of input i; out[p][i] and clamped[i] are its results. */
int glint_effect_eval_port_batch(const glint_model *model, size_t count, const int32_t *const *in, int32_t *const *out,
                                 uint8_t *clamped);

#ifdef __cplusplus
}
#endif
#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

#endif
