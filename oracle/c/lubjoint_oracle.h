/* C interface of what needs a solver: tables of the compiled laws, and forces that come from no law. Conventions as in
 * lubjoint.h: 0, or an error number of <errno.h>, and a message. The Python package loads it at the first call that
 * needs it. */
#ifndef LUBJOINT_ORACLE_H
#define LUBJOINT_ORACLE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LUBJOINT_ORACLE_API __attribute__((visibility("default")))

/* What went wrong in this thread's last call that did not return 0; never null. */
LUBJOINT_ORACLE_API const char* lubjoint_oracle_message(void);

/* Called as a table is compiled, by one thread at a time: so many pieces of work are done, of so many. */
typedef void (*lubjoint_oracle_progress)(size_t done, size_t all);

/* The text of a compiled law's table for one L/D (0.05 to 10): one that ships in a folder (null: none), or from the
 * user's cache (XDG_CACHE_HOME, else ~/.cache), or compiled now, on all cores, and kept there: full, half and dynamic
 * films in seconds, finite_reynolds in a minute or two. A file that is damaged or another's is made again. notes: what
 * there is to tell of that, a line each; null: of no interest. text, notes: to be given back to lubjoint_oracle_free.
 * progress may be null. */
LUBJOINT_ORACLE_API int lubjoint_oracle_film(const char* law, double length_to_diameter, const char* shipped,
                                             lubjoint_oracle_progress progress, char** text, char** notes);
LUBJOINT_ORACLE_API void lubjoint_oracle_free(char* text);

/* Force of a film on the journal [N], radial and tangential, of n states (eccentricity ratio, slip rate a and squeeze rate
 * b [1/s]; arrays without gaps), without any force law. bearing: viscosity, length, radius, clearance. film: finite_full,
 * finite_half, finite_dynamic or finite_reynolds, by solving Reynolds' equation; or short_full, short_half,
 * short_dynamic, long_full, long_half, long_half_eq5 or long_dynamic, by integrating their pressure. onset: of
 * finite_reynolds, "free" or "maximum_film"; null: free. tolerance: of the error over |F|, 1e-12 to 0.1 (integrals: from
 * 1e-15); 0: 1e-3 (integrals: 1e-13). radial_error, tangential_error: estimated bounds [N], also where the tolerance is
 * not met. EDOM: a row has no film; it is named, and those before it are answered. */
LUBJOINT_ORACLE_API int lubjoint_oracle_force(const char* film, const double bearing[4], const char* onset,
                                              double tolerance, size_t n, const double* eccentricity_ratio,
                                              const double* slip_rate, const double* squeeze_rate, double* radial,
                                              double* tangential, double* radial_error, double* tangential_error);

#ifdef __cplusplus
}
#endif

#endif
