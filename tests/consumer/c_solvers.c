/* The installed C interfaces of solvers, runs and verification: c_solvers DATA_FOLDER. */
#include <lubjoint_oracle.h>
#include <lubjoint_simulate.h>
#include <lubjoint_verify.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed(const char* what, const char* message) {
  fprintf(stderr, "%s: %s\n", what, message);
  return 1;
}

int main(int count, char** arguments) {
  char path[4096];
  if (count != 2) return failed("usage", "c_solvers DATA_FOLDER");

  /* A full film has the tangential force of its wedge alone, and a force twice as large where it turns twice as fast. */
  const double bearing[4] = {0.1, 0.02, 0.02, 1e-4}, ratio[2] = {0.5, 0.5}, slip[2] = {50, 100}, squeeze[2] = {0, 0};
  double radial[2], tangential[2], radial_error[2], tangential_error[2];
  if (lubjoint_oracle_force("finite_full", bearing, NULL, 1e-6, 2, ratio, slip, squeeze, radial, tangential, radial_error,
                            tangential_error) != 0) {
    return failed("force", lubjoint_oracle_message());
  }
  if (!(fabs(radial[0]) <= 1e-6 * tangential[0]) || !(fabs(tangential[1] / tangential[0] - 2) < 1e-5)) {
    return failed("force", "is not that of a wedge");
  }
  if (lubjoint_oracle_force("finite", bearing, NULL, 0, 1, ratio, slip, squeeze, radial, tangential, radial_error,
                            tangential_error) == 0 ||
      strstr(lubjoint_oracle_message(), "finite_full") == NULL) {
    return failed("a film that is not there", lubjoint_oracle_message());
  }

  lubjoint_simulate_request run = {0};
  lubjoint_simulation* motion = NULL;
  snprintf(path, sizeof path, "%s/scenes/journal.toml", arguments[1]);
  run.file = path;
  if (lubjoint_simulate(&run, &motion) != 0) return failed("run", lubjoint_simulate_message());
  if (!lubjoint_simulation_finished(motion) || strcmp(lubjoint_simulation_column(motion, 0), "t") != 0) {
    return failed("run", lubjoint_simulation_summary(motion));
  }
  lubjoint_simulation_free(motion);

  /* Forces of zero are wrong, and said to be. */
  lubjoint_verify_request asked = {0};
  size_t states = 0;
  int verdict = 0;
  char* text = NULL;
  double* zeros;
  snprintf(path, sizeof path, "%s/golden", arguments[1]);
  asked.quantities = "polar";
  asked.law = "short_half";
  asked.golden = path;
  asked.at_most = 20;
  if (lubjoint_verify_count(&asked, &states) != 0) return failed("states", lubjoint_verify_message());
  if (states != 20) return failed("states", "are not twenty");
  zeros = calloc(2 * states, sizeof *zeros);
  if (zeros == NULL) return failed("states", "no memory");
  if (lubjoint_verify_judge(&asked, zeros, 0, 1, &verdict, &text, NULL) != 0) {
    return failed("judge", lubjoint_verify_message());
  }
  free(zeros);
  if (verdict != 1 || strstr(text, "disagrees") == NULL) return failed("judge", text);
  lubjoint_verify_free(text);
  return 0;
}
