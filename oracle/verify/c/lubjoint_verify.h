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

/* What is asked: the golden states, the designed ones, and `random` others. */
typedef struct {
  const char* quantities;
  const char* golden; /* folder of the golden data */
  size_t random;
  uint64_t seed;
} lubjoint_verify_request;

/* Number of states. */
LUBJOINT_VERIFY_API int lubjoint_verify_count(const lubjoint_verify_request* request, size_t* count);

/* The states, column after column: out has room for count times the number of columns. */
LUBJOINT_VERIFY_API int lubjoint_verify_states(const lubjoint_verify_request* request, double* out);

/* Judges answers, given column after column. law: a name, or "auto".
 * verdict: 0 agrees, 1 disagrees, 2 could not be judged. text and json: reports, to be given back to
 * lubjoint_verify_free; either may be null. */
LUBJOINT_VERIFY_API int lubjoint_verify_judge(const char* law, const lubjoint_verify_request* request,
                                              const double* answers, int* verdict, char** text, char** json);
LUBJOINT_VERIFY_API void lubjoint_verify_free(char* report);

#ifdef __cplusplus
}
#endif

#endif
