/* The highlight around cos = 0.98 at n = 50, from C. */
#include <stdio.h>

#include <glint.h>

int main(void) {
    glint_model *bps = glint_open_lobe("bps", "p12");
    uint32_t y;
    if (bps == NULL || glint_eval(bps, 50, 256901, &y) != 0) {
        fprintf(stderr, "%s\n", glint_error());
        return 1;
    }
    printf("y %u = %.4f\n", (unsigned)y, y / 4096.0);
    glint_close(bps);
    return 0;
}
