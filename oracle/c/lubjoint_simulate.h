/* C interface of runs of scene files. Conventions as in lubjoint.h: 0, or an error number of <errno.h>, and a message. The
 * Python package loads it at its first run. */
#ifndef LUBJOINT_SIMULATE_H
#define LUBJOINT_SIMULATE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LUBJOINT_SIMULATE_API __attribute__((visibility("default")))

/* What went wrong in this thread's last call that did not return 0; never null. */
LUBJOINT_SIMULATE_API const char* lubjoint_simulate_message(void);

/* Called as a film's table is compiled, by one thread at a time: so many pieces of work are done, of so many. */
typedef void (*lubjoint_simulate_progress)(size_t done, size_t all);

/* What to run, and how. Texts are UTF-8; a pointer that may be null leaves its choice to the scene. */
typedef struct lubjoint_simulate_request {
  const char* file;       /* a scene file (TOML), in the plane or in space (dimension = 3) */
  const char* text;       /* in place of a file: its text; one of the two is null */
  const char* law;        /* film law of all joints that have a film; may be null */
  const char* integrator; /* may be null */
  const double* rtol;     /* relative tolerance, also the absolute one in clearances, 1e-14 to below 1; may be null */
  const double* duration; /* [s], above 0; may be null */
  const double* after;    /* extremes from this time on, too [s], in the plane; may be null */
  const char* films;      /* folder of tables of compiled laws that ship; null: none */
  lubjoint_simulate_progress progress; /* of a table that has to be compiled; may be null */
  int last_revolution; /* not 0: extremes of the last revolution of the scene's driver, or of its journal, too; in the
                          plane, and not with `after` */
} lubjoint_simulate_request;

/* A run: what `lubjoint simulate --out --json` writes of it. */
typedef struct lubjoint_simulation lubjoint_simulation;

/* Runs a scene. A run that stops before its end is a run, too: lubjoint_simulation_finished says so, and the summary's
 * `message` why. run: to be given back to lubjoint_simulation_free. EINVAL: a scene or a setting that is not allowed; the
 * message names file, line, key, what was given and what is allowed. */
LUBJOINT_SIMULATE_API int lubjoint_simulate(const lubjoint_simulate_request* request, lubjoint_simulation** run);

/* The trajectory: rows in time's order, columns with the names of the CSV ("t" first, SI units). */
LUBJOINT_SIMULATE_API size_t lubjoint_simulation_rows(const lubjoint_simulation* run);
LUBJOINT_SIMULATE_API size_t lubjoint_simulation_columns(const lubjoint_simulation* run);
/* Name of column i; null after the last. */
LUBJOINT_SIMULATE_API const char* lubjoint_simulation_column(const lubjoint_simulation* run, size_t i);
/* The numbers, column after column: out has room for rows times columns. What is not defined (a torque of oil in dry
 * contact), an empty field of the CSV, is NaN; nothing else is. */
LUBJOINT_SIMULATE_API void lubjoint_simulation_values(const lubjoint_simulation* run, double* out);

/* 1: the run got to its end; 0: it stopped before. */
LUBJOINT_SIMULATE_API int lubjoint_simulation_finished(const lubjoint_simulation* run);
/* The summary, one JSON object. */
LUBJOINT_SIMULATE_API const char* lubjoint_simulation_summary(const lubjoint_simulation* run);
/* What the command would warn of, number i; null after the last. */
LUBJOINT_SIMULATE_API const char* lubjoint_simulation_warning(const lubjoint_simulation* run, size_t i);

LUBJOINT_SIMULATE_API void lubjoint_simulation_free(lubjoint_simulation* run);

#ifdef __cplusplus
}
#endif

#endif
