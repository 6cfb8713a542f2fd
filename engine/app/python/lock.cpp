#include "engine/app/python/lock.hpp"

#include <Python.h>

namespace stepwire::python {

namespace {

/// Registration of this thread with Python until the thread ends. Registering takes longer than a call.
class KnownThread {
 public:
  KnownThread() : state_(PyGILState_Ensure()), thread_(PyEval_SaveThread()) {}
  ~KnownThread() {
    if (!Py_IsInitialized()) return;
    PyEval_RestoreThread(thread_);
    PyGILState_Release(state_);
  }

 private:
  PyGILState_STATE state_;
  PyThreadState* thread_;
};

}  // namespace

Lock::Lock() {
  if (!PyGILState_GetThisThreadState()) {
    thread_local KnownThread known;
    static_cast<void>(known);
  }
  state_ = static_cast<int>(PyGILState_Ensure());
}

Lock::~Lock() {
  PyGILState_Release(static_cast<PyGILState_STATE>(state_));
}

Unlocked::Unlocked() : thread_(PyEval_SaveThread()) {}

Unlocked::~Unlocked() {
  PyEval_RestoreThread(static_cast<PyThreadState*>(thread_));
}

Held Held::one_more(_object* object) {
  Py_XINCREF(object);
  return Held(object);
}

void Held::put(_object* owned) {
  _object* dropped = std::exchange(object_, owned);
  Py_XDECREF(dropped);
}

Held::~Held() {
  if (!object_ || !Py_IsInitialized()) return;
  const Lock lock;
  Py_DECREF(object_);
}

}  // namespace stepwire::python
