#pragma once

#include "rovio_sfm/io/map_store_database.h"

namespace rovio_sfm {

// Of the tables; docs/map_store.md tells what changed. Older ones are migrated, newer ones refused.
constexpr int kStoreVersion = 2;

// Makes the tables in a new file; checks that another one is a map store of a version that is
// understood. Sets how safely SQLite writes: a committed transaction survives a loss of power.
// Throws StoreError that names the file, what it is and what was expected.
void OpenSchema(StoreAccess access, StoreDatabase* database);

}  // namespace rovio_sfm
