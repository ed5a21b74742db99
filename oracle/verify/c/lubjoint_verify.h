/* C interface of the verification: states out, answers in, report back. Conventions as in lubjoint.h. */
#ifndef LUBJOINT_VERIFY_H
#define LUBJOINT_VERIFY_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LUBJOINT_VERIFY_API __attribute__((visibility("default")))

/* What went wrong in this thread's last call that did not return 0; never null. */
LUBJOINT_VERIFY_API const char* lubjoint_verify_message(void);

/* Names of the columns of states and answers, comma-separated; null for quantities that are not there. */
LUBJOINT_VERIFY_API const char* lubjoint_verify_state_columns(const char* quantities);
LUBJOINT_VERIFY_API const char* lubjoint_verify_answer_columns(const char* quantities);

/* What is asked: the golden states, the designed ones, and `random` others; of a film of finite length (law finite_full,
 * finite_half, finite_dynamic or finite_reynolds; quantities other than dimensionless and contact, and extent not of
 * finite_reynolds) states of its own, 56 loads or 120 motions, so that golden, random and seed are not read. */
typedef struct {
  const char* quantities; /* "cartesian", "polar", "coefficients" and so on: what `lubjoint verify --help` lists */
  const char* law;        /* that is claimed; null or "auto": which one is to be found out, of those of no finite length */
  const char* onset;      /* of finite_reynolds: "free" or "maximum_film"; null: free */
  const char* golden;     /* folder of the golden data */
  size_t random;          /* number of random states */
  uint64_t seed;          /* of these */
  const char* only;       /* domain, "omega_sum > 0, eccentricity_ratio > 0"; null: everywhere */
  int steady;             /* other than 0: steady rotation in a bearing at rest alone */
  const char* shear;      /* of losses: "film", "flooded", "striated"; null: "film" */
  size_t at_most;         /* states in all, chosen to cover the regimes; 0: all of them */
} lubjoint_verify_request;

/* Number of states. */
LUBJOINT_VERIFY_API int lubjoint_verify_count(const lubjoint_verify_request* request, size_t* count);

/* The states, column after column: out has room for count times the number of columns. */
LUBJOINT_VERIFY_API int lubjoint_verify_states(const lubjoint_verify_request* request, double* out);

/* Judges answers, given column after column. tolerance: error over the answer's size that is right for a numerical
 * program; 0: that of rounding, of films of finite length 1e-3. unit: of forces without dimensions, over S omega; otherwise 1.
 * A table's column (coefficients, equilibrium, losses) of which no number is finite counts as not given.
 * verdict: 0 agrees, 1 disagrees, 2 could not be judged. text and json: reports, to be given back to
 * lubjoint_verify_free; either may be null. */
LUBJOINT_VERIFY_API int lubjoint_verify_judge(const lubjoint_verify_request* request, const double* answers,
                                              double tolerance, double unit, int* verdict, char** text, char** json);
LUBJOINT_VERIFY_API void lubjoint_verify_free(char* report);

#ifdef __cplusplus
}
#endif

#endif
