// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <Eigen/Core>
namespace KDL {
class Vector { public: double data[3]; Vector(); Vector(double, double, double); double x() const; double y() const; double z() const;
  void x(double); void y(double); void z(double); double& operator()(int); double operator()(int) const; double& operator[](int);
  double operator[](int) const; double Norm() const; double Normalize(double = 1e-9); static Vector Zero(); void ReverseSign();
  Vector& operator+=(const Vector&); Vector& operator-=(const Vector&); };
Vector operator+(const Vector&, const Vector&); Vector operator-(const Vector&, const Vector&); Vector operator-(const Vector&);
  Vector operator*(const Vector&, const Vector&); Vector operator*(const Vector&, double); Vector operator*(double, const Vector&);
  Vector operator/(const Vector&, double); double dot(const Vector&, const Vector&); bool operator==(const Vector&, const Vector&);
  bool Equal(const Vector&, const Vector&, double = 1e-6);
class Rotation { public: double data[9]; Rotation(); Rotation(double, double, double, double, double, double, double, double, double);
  double& operator()(int, int); double operator()(int, int) const; void GetRPY(double&, double&, double&) const;
  void GetQuaternion(double&, double&, double&, double&) const; void GetEulerZYX(double&, double&, double&) const; Vector GetRot() const;
  double GetRotAngle(Vector&, double = 1e-6) const; Rotation Inverse() const; static Rotation Identity();
  static Rotation RPY(double, double, double); static Rotation Quaternion(double, double, double, double); static Rotation RotX(double);
  static Rotation RotY(double); static Rotation RotZ(double); static Rotation Rot(const Vector&, double);
  static Rotation EulerZYX(double, double, double); Vector UnitX() const; Vector UnitY() const; Vector UnitZ() const;
  Vector operator*(const Vector&) const; Rotation operator*(const Rotation&) const; };
class Twist { public: Vector vel, rot; Twist(); Twist(const Vector&, const Vector&); static Twist Zero(); double& operator()(int);
  double operator()(int) const; double& operator[](int); Twist& operator+=(const Twist&); Twist RefPoint(const Vector&) const; };
  Twist operator+(const Twist&, const Twist&); Twist operator-(const Twist&, const Twist&); Twist operator*(const Twist&, double);
  Twist operator*(double, const Twist&); Twist operator*(const Rotation&, const Twist&);
class Wrench { public: Vector force, torque; Wrench(); Wrench(const Vector&, const Vector&); static Wrench Zero(); double& operator()(int);
  double operator()(int) const; };
class Frame { public: Vector p; Rotation M; Frame(); explicit Frame(const Rotation&); explicit Frame(const Vector&);
  Frame(const Rotation&, const Vector&); double operator()(int, int) const; Frame Inverse() const; static Frame Identity();
  void Make4x4(double*); void Integrate(const Twist&, double); Vector operator*(const Vector&) const; Frame operator*(const Frame&) const;
  Twist operator*(const Twist&) const; Wrench operator*(const Wrench&) const; }; Twist diff(const Frame&, const Frame&, double = 1);
  Vector diff(const Vector&, const Vector&, double = 1); Frame addDelta(const Frame&, const Twist&, double = 1);
class JntArray { public: Eigen::VectorXd data; JntArray(); explicit JntArray(unsigned); void resize(unsigned); unsigned rows() const;
  unsigned columns() const; double& operator()(unsigned, unsigned = 0); double operator()(unsigned, unsigned = 0) const; };
  class Jacobian { public: Eigen::MatrixXd data; Jacobian(); explicit Jacobian(unsigned); void resize(unsigned); unsigned rows() const;
  unsigned columns() const; double& operator()(unsigned, unsigned); }; class JntArrayVel { public: JntArray q, qdot;
  explicit JntArrayVel(unsigned = 0); };
class Joint { public: enum JointType { RotAxis, RotX, RotY, RotZ, TransAxis, TransX, TransY, TransZ, None }; Joint(JointType = None);
  const std::string& getName() const; JointType getType() const; Vector JointAxis() const; };
  class Segment { public: const std::string& getName() const; const Joint& getJoint() const; Frame getFrameToTip() const;
  Frame pose(double) const; };
class Chain { public: std::vector<Segment> segments; unsigned getNrOfJoints() const; unsigned getNrOfSegments() const;
  const Segment& getSegment(unsigned) const; void addSegment(const Segment&); };
  class Tree { public: bool getChain(const std::string&, const std::string&, Chain&) const; unsigned getNrOfJoints() const; };
#define ROSARCH_SOLVER(Name) class Name { public: template <class... A> Name(const A&...); template <class... A> int JntToCart(A&&...); \
  template <class... A> int CartToJnt(A&&...); template <class... A> int JntToJac(A&&...); };
ROSARCH_SOLVER(ChainFkSolverPos_recursive) ROSARCH_SOLVER(ChainFkSolverPos) ROSARCH_SOLVER(ChainIkSolverPos_NR)
  ROSARCH_SOLVER(ChainIkSolverPos_NR_JL) ROSARCH_SOLVER(ChainIkSolverVel_pinv) ROSARCH_SOLVER(ChainIkSolverVel_wdls)
  ROSARCH_SOLVER(ChainJntToJacSolver) ROSARCH_SOLVER(ChainFkSolverVel_recursive) ROSARCH_SOLVER(ChainIdSolver_RNE)
#undef ROSARCH_SOLVER
}
namespace kdl_parser { template <class A> bool treeFromUrdfModel(const A&, KDL::Tree&); bool treeFromString(const std::string&, KDL::Tree&);
  bool treeFromParam(const std::string&, KDL::Tree&); bool treeFromFile(const std::string&, KDL::Tree&); }
