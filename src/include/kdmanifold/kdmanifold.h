// SPDX-License-Identifier: MIT
// Includes the whole public interface but the tables for programs (options.h, reports.h). A mesh
// goes through read_mesh, build_grid and extract to write_mesh.
#pragma once

#include "kdmanifold/account.h"
#include "kdmanifold/analyze.h"
#include "kdmanifold/boolean.h"
#include "kdmanifold/boolean_scene.h"
#include "kdmanifold/build.h"
#include "kdmanifold/deviation.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/grid.h"
#include "kdmanifold/grid_io.h"
#include "kdmanifold/make_manifold.h"
#include "kdmanifold/merge.h"
#include "kdmanifold/mesh.h"
#include "kdmanifold/mesh_io.h"
#include "kdmanifold/progress.h"
#include "kdmanifold/reduce.h"
#include "kdmanifold/simplify.h"
#include "kdmanifold/thicken.h"
#include "kdmanifold/threads.h"
#include "kdmanifold/types.h"
#include "kdmanifold/version.h"
#include "kdmanifold/warnings.h"
