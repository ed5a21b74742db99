# How far the Pinkus-Sternlicht law is from the long dynamic film.
set(reports_pinkus_sternlicht_sources
  pinkus_sternlicht_difference.cpp)
