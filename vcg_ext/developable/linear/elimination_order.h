// SPDX-License-Identifier: GPL-3.0-or-later
// elimination_order.h: in which order the rows of a symmetric matrix are eliminated.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace developable {

/// The rows of a symmetric matrix in an order that leaves its factor few numbers: nested dissection by METIS
/// (Karypis and Kumar 1998) where the library was built with CHOLMOD, else minimum degree. It is among the
/// dearest there is to find, and serves all matrices whose patterns are similar. Throws std::bad_alloc when
/// there is too little memory. \param lower  of it only the lower triangle's pattern is read
std::vector<int> eliminationOrder(const Eigen::SparseMatrix<double>& lower);

/// That of a matrix with some rows, which are neighbours, for each row of the other.
std::vector<int> eliminationOrder(const std::vector<int>& ofOther, int rowsForEach);

} // namespace developable
