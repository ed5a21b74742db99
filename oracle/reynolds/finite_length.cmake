# Sources of the finite-length film.
set(finite_length_sources
  cavitated_elements.cpp
  cavitated_film.cpp
  cavitated_grid.cpp
  circumferential_modes.cpp
  envelope_cholesky.cpp
  film_onset.cpp
  finite_force.cpp
  finite_length.cpp
  lobatto.cpp
  smooth_film.cpp
  strip_mode.cpp)
