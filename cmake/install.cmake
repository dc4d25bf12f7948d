# The install tree and the package that find_package(voronaut) reads.
