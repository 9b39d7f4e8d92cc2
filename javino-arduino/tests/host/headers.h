/** @file What most tests include, compiled once for all of them. */
#ifndef HEADERS_H
#define HEADERS_H

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#endif
