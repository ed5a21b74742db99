/* A C program on the C interface of runs; compiled as C11 by the tests. Ends with the number of the first claim that fails. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "oracle/c/lubjoint_simulate.h"

/* The number behind a key of the summary, after the words that it follows; NaN if it is not there. */
static double number_of(const lubjoint_simulation* run, const char* words, const char* key) {
  const char* at = strstr(lubjoint_simulation_summary(run), words);
  if (at) at = strstr(at, key);
  return at ? strtod(at + strlen(key), NULL) : NAN;
}

static int refused(const lubjoint_simulate_request* request, const char* words) {
  lubjoint_simulation* run = NULL;
  const char* said;
  if (lubjoint_simulate(request, &run) != EINVAL || run) return 0;
  said = lubjoint_simulate_message();
  return strstr(said, words) && strstr(said, "allowed") && !strstr(said, "--");
}

int main(int count, char** words) {
  const double duration = 0.024, short_duration = 0.01, after = 0.012;
  lubjoint_simulate_request request;
  lubjoint_simulation *run = NULL, *last = NULL;
  double all, late;
  if (count != 3) return 1;
  memset(&request, 0, sizeof request);
  request.file = words[1]; /* a slider-crank, a revolution in 0.012 s */
  request.duration = &duration;
  if (lubjoint_simulate(&request, &run) || !lubjoint_simulation_finished(run)) return 2;
  if (strstr(lubjoint_simulation_summary(run), "\"after\"")) return 3; /* not asked for */
  all = number_of(run, "\"joints\"", "\"max_force\":");
  lubjoint_simulation_free(run);

  /* the last revolution begins at 0.012 s, and has no larger force than the whole run */
  request.last_revolution = 1;
  if (lubjoint_simulate(&request, &last)) return 4;
  if (!(fabs(number_of(last, "\"after\"", "\"t\":") - after) < 1e-12 * after)) return 5; /* a few roundings */
  late = number_of(last, "\"after\"", "\"max_force\":");
  if (number_of(last, "\"joints\"", "\"max_force\":") != all || !(late > 0 && late <= all)) return 6;
  if (!(number_of(last, "\"after\"", "\"t_max_force\":") >= after)) return 7;
  lubjoint_simulation_free(last);

  request.after = &after;
  if (!refused(&request, "after and last_revolution are given")) return 8;
  request.after = NULL;
  request.duration = &short_duration;
  if (!refused(&request, "last_revolution: the scene ends before one revolution")) return 9;
  request.duration = NULL;
  request.file = words[2]; /* in space */
  if (!refused(&request, "last_revolution is for scenes in the plane")) return 10;
  return 0;
}
