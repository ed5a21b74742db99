# Films whose force is a one-dimensional integral.
set(reynolds_one_dimensional_sources
  film_edges.cpp
  film_integral.cpp
  film_name.cpp
  film_nodes.cpp
  film_sums.cpp)
