#include "ida/stock_newton.hpp"

#include <ida/ida.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <stdexcept>

namespace talus::ida {
namespace {

int refresh(realtype t, realtype c_j, N_Vector y, N_Vector yp, N_Vector, SUNMatrix, void* user, N_Vector, N_Vector,
            N_Vector) {
  return bridge::flag(static_cast<Equations*>(user)->refresh(t, view(y), view(yp), c_j));
}

}  // namespace

StockNewton::StockNewton(Equations& equations, void* ida_memory, N_Vector shape, SUNContext context)
    : newton_(SUNNonlinSol_Newton(shape, context)), linear_(equations, context) {
  if (IDASetNonlinearSolver(ida_memory, newton_) != IDA_SUCCESS ||
      IDASetLinearSolver(ida_memory, linear_.solver(), linear_.matrix()) != IDA_SUCCESS ||
      IDASetJacFn(ida_memory, refresh) != IDA_SUCCESS) {
    throw std::runtime_error("IDA does not accept the stock Newton solver");
  }
}

StockNewton::~StockNewton() { SUNNonlinSolFree(newton_); }

}  // namespace talus::ida
