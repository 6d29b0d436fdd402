// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __CUDA__
// attributes of functions do not choose among them: what is called is found from host and kernel alike
#pragma clang force_cuda_host_device begin
#define __global__ __attribute__((global))
#else
#define __global__
#endif
#define __host__
#define __device__
#define __shared__
#define __constant__
#define __managed__
#define __forceinline__ inline
#define __noinline__
#define __launch_bounds__(...)

typedef struct CUstream_st* cudaStream_t;
typedef struct CUevent_st* cudaEvent_t;
typedef struct cudaArray* cudaArray_t;
typedef unsigned long long cudaTextureObject_t;
typedef unsigned long long cudaSurfaceObject_t;

enum cudaError { cudaSuccess, cudaErrorInvalidValue, cudaErrorMemoryAllocation, cudaErrorNotReady, cudaErrorUnknown };
typedef enum cudaError cudaError_t;
enum cudaMemcpyKind { cudaMemcpyHostToHost, cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice, cudaMemcpyDefault };
enum cudaChannelFormatKind { cudaChannelFormatKindSigned, cudaChannelFormatKindUnsigned, cudaChannelFormatKindFloat, cudaChannelFormatKindNone };
enum cudaResourceType { cudaResourceTypeArray, cudaResourceTypeMipmappedArray, cudaResourceTypeLinear, cudaResourceTypePitch2D };
enum cudaTextureAddressMode { cudaAddressModeWrap, cudaAddressModeClamp, cudaAddressModeMirror, cudaAddressModeBorder };
enum cudaTextureFilterMode { cudaFilterModePoint, cudaFilterModeLinear };
enum cudaTextureReadMode { cudaReadModeElementType, cudaReadModeNormalizedFloat };
enum {
  cudaHostRegisterDefault, cudaHostRegisterPortable, cudaHostRegisterMapped, cudaHostAllocDefault, cudaHostAllocMapped, cudaMemAttachGlobal,
  cudaDeviceMapHost, cudaDeviceScheduleBlockingSync, cudaStreamNonBlocking, cudaEventDefault, cudaEventDisableTiming,
  cudaTextureType1D, cudaTextureType2D, cudaTextureType3D, cudaTextureType1DLayered, cudaTextureType2DLayered
};

struct cudaChannelFormatDesc { int x, y, z, w; enum cudaChannelFormatKind f; };
struct cudaResourceDesc {
  enum cudaResourceType resType;
  union {
    struct { cudaArray_t array; } array;
    struct { void* devPtr; struct cudaChannelFormatDesc desc; unsigned long sizeInBytes; } linear;
    struct { void* devPtr; struct cudaChannelFormatDesc desc; unsigned long width, height, pitchInBytes; } pitch2D;
  } res;
};
struct cudaTextureDesc {
  enum cudaTextureAddressMode addressMode[3];
  enum cudaTextureFilterMode filterMode;
  enum cudaTextureReadMode readMode;
  int sRGB;
  float borderColor[4];
  int normalizedCoords;
};
struct cudaDeviceProp {
  char name[256];
  unsigned long totalGlobalMem, sharedMemPerBlock, totalConstMem, memPitch, textureAlignment;
  int regsPerBlock, warpSize, maxThreadsPerBlock, maxThreadsDim[3], maxGridSize[3], clockRate, major, minor, multiProcessorCount;
  int integrated, canMapHostMemory, computeMode, concurrentKernels, memoryClockRate, memoryBusWidth, l2CacheSize, maxThreadsPerMultiProcessor;
};

#define ROSARCH_VECTORS(type, name) \
  struct name##1 { type x; }; struct name##2 { type x, y; }; struct name##3 { type x, y, z; }; struct name##4 { type x, y, z, w; };
ROSARCH_VECTORS(char, char)
ROSARCH_VECTORS(unsigned char, uchar)
ROSARCH_VECTORS(short, short)
ROSARCH_VECTORS(unsigned short, ushort)
ROSARCH_VECTORS(int, int)
ROSARCH_VECTORS(unsigned int, uint)
ROSARCH_VECTORS(long, long)
ROSARCH_VECTORS(unsigned long, ulong)
ROSARCH_VECTORS(float, float)
ROSARCH_VECTORS(double, double)
#undef ROSARCH_VECTORS

#ifdef __cplusplus
struct dim3 {
  unsigned int x, y, z;
  dim3(unsigned int x = 1, unsigned int y = 1, unsigned int z = 1);
  dim3(uint3);
};
// what `kernel<<<...>>>` calls
int __cudaPushCallConfiguration(dim3 grid, dim3 block, unsigned long shared = 0, void* stream = nullptr);
int cudaConfigureCall(dim3 grid, dim3 block, unsigned long shared = 0, void* stream = nullptr);

extern const uint3 threadIdx, blockIdx;
extern const dim3 blockDim, gridDim;
extern const int warpSize;

#define ROSARCH_MAKE(name) name make_##name(...);
ROSARCH_MAKE(float1) ROSARCH_MAKE(float2) ROSARCH_MAKE(float3) ROSARCH_MAKE(float4)
ROSARCH_MAKE(double1) ROSARCH_MAKE(double2) ROSARCH_MAKE(double3) ROSARCH_MAKE(double4)
ROSARCH_MAKE(int1) ROSARCH_MAKE(int2) ROSARCH_MAKE(int3) ROSARCH_MAKE(int4)
ROSARCH_MAKE(uint1) ROSARCH_MAKE(uint2) ROSARCH_MAKE(uint3) ROSARCH_MAKE(uint4)
ROSARCH_MAKE(uchar1) ROSARCH_MAKE(uchar2) ROSARCH_MAKE(uchar3) ROSARCH_MAKE(uchar4)
#undef ROSARCH_MAKE

#define ROSARCH_CUDA(name) template <typename... A> cudaError_t name(A&&...);
ROSARCH_CUDA(cudaMalloc) ROSARCH_CUDA(cudaMallocHost) ROSARCH_CUDA(cudaMallocManaged) ROSARCH_CUDA(cudaMallocPitch) ROSARCH_CUDA(cudaMallocArray)
ROSARCH_CUDA(cudaMalloc3D) ROSARCH_CUDA(cudaMalloc3DArray) ROSARCH_CUDA(cudaHostAlloc) ROSARCH_CUDA(cudaHostGetDevicePointer)
ROSARCH_CUDA(cudaHostRegister) ROSARCH_CUDA(cudaHostUnregister) ROSARCH_CUDA(cudaFree) ROSARCH_CUDA(cudaFreeHost) ROSARCH_CUDA(cudaFreeArray)
ROSARCH_CUDA(cudaMemcpy) ROSARCH_CUDA(cudaMemcpyAsync) ROSARCH_CUDA(cudaMemcpy2D) ROSARCH_CUDA(cudaMemcpy2DAsync) ROSARCH_CUDA(cudaMemcpyToArray)
ROSARCH_CUDA(cudaMemcpy2DToArray) ROSARCH_CUDA(cudaMemcpyToSymbol) ROSARCH_CUDA(cudaMemcpyToSymbolAsync) ROSARCH_CUDA(cudaMemcpyFromSymbol)
ROSARCH_CUDA(cudaMemset) ROSARCH_CUDA(cudaMemsetAsync) ROSARCH_CUDA(cudaMemset2D) ROSARCH_CUDA(cudaMemGetInfo) ROSARCH_CUDA(cudaMemPrefetchAsync)
ROSARCH_CUDA(cudaGetLastError) ROSARCH_CUDA(cudaPeekAtLastError) ROSARCH_CUDA(cudaDeviceSynchronize) ROSARCH_CUDA(cudaThreadSynchronize)
ROSARCH_CUDA(cudaDeviceReset) ROSARCH_CUDA(cudaSetDevice) ROSARCH_CUDA(cudaSetDeviceFlags) ROSARCH_CUDA(cudaGetDevice) ROSARCH_CUDA(cudaGetDeviceCount)
ROSARCH_CUDA(cudaGetDeviceProperties) ROSARCH_CUDA(cudaDriverGetVersion) ROSARCH_CUDA(cudaRuntimeGetVersion)
ROSARCH_CUDA(cudaStreamCreate) ROSARCH_CUDA(cudaStreamCreateWithFlags) ROSARCH_CUDA(cudaStreamDestroy) ROSARCH_CUDA(cudaStreamSynchronize)
ROSARCH_CUDA(cudaStreamAttachMemAsync) ROSARCH_CUDA(cudaStreamWaitEvent) ROSARCH_CUDA(cudaEventCreate) ROSARCH_CUDA(cudaEventCreateWithFlags)
ROSARCH_CUDA(cudaEventDestroy) ROSARCH_CUDA(cudaEventRecord) ROSARCH_CUDA(cudaEventSynchronize) ROSARCH_CUDA(cudaEventElapsedTime)
ROSARCH_CUDA(cudaCreateTextureObject) ROSARCH_CUDA(cudaDestroyTextureObject) ROSARCH_CUDA(cudaBindTexture) ROSARCH_CUDA(cudaBindTexture2D)
ROSARCH_CUDA(cudaBindTextureToArray) ROSARCH_CUDA(cudaUnbindTexture) ROSARCH_CUDA(cudaFuncSetCacheConfig) ROSARCH_CUDA(cudaLaunchKernel)
#undef ROSARCH_CUDA
const char* cudaGetErrorString(cudaError_t error);
const char* cudaGetErrorName(cudaError_t error);
template <typename T> cudaChannelFormatDesc cudaCreateChannelDesc();
cudaChannelFormatDesc cudaCreateChannelDesc(int x, int y, int z, int w, cudaChannelFormatKind kind);

template <typename T, int Type = cudaTextureType1D, int Mode = cudaReadModeElementType> struct texture {
  template <typename... A> texture(A&&...);
  int normalized;
  cudaTextureFilterMode filterMode;
  cudaTextureAddressMode addressMode[3];
  cudaChannelFormatDesc channelDesc;
};
#define ROSARCH_TEXTURE(name) \
  template <typename T, typename... A> T name(cudaTextureObject_t, A...); \
  template <typename T, int Type, int Mode, typename... A> T name(texture<T, Type, Mode>, A...);
ROSARCH_TEXTURE(tex1D) ROSARCH_TEXTURE(tex1Dfetch) ROSARCH_TEXTURE(tex2D) ROSARCH_TEXTURE(tex3D) ROSARCH_TEXTURE(tex1DLayered) ROSARCH_TEXTURE(tex2DLayered)
#undef ROSARCH_TEXTURE

#ifndef __CUDA__
void __syncthreads();
#endif
void __syncwarp(unsigned int mask = 0xffffffff);
void __threadfence();
void __threadfence_block();
#define ROSARCH_ATOMIC(name) template <typename T, typename... A> T name(T* address, A... value);
ROSARCH_ATOMIC(atomicAdd) ROSARCH_ATOMIC(atomicSub) ROSARCH_ATOMIC(atomicExch) ROSARCH_ATOMIC(atomicMin) ROSARCH_ATOMIC(atomicMax) ROSARCH_ATOMIC(atomicInc)
ROSARCH_ATOMIC(atomicDec) ROSARCH_ATOMIC(atomicCAS) ROSARCH_ATOMIC(atomicAnd) ROSARCH_ATOMIC(atomicOr) ROSARCH_ATOMIC(atomicXor)
#undef ROSARCH_ATOMIC
#define ROSARCH_MATH(name) float name(float, ...);
ROSARCH_MATH(__sinf) ROSARCH_MATH(__cosf) ROSARCH_MATH(__tanf) ROSARCH_MATH(__expf) ROSARCH_MATH(__logf) ROSARCH_MATH(__log2f) ROSARCH_MATH(__powf)
ROSARCH_MATH(__fdividef) ROSARCH_MATH(__saturatef) ROSARCH_MATH(__fmul_rn) ROSARCH_MATH(__fadd_rn) ROSARCH_MATH(__frcp_rn) ROSARCH_MATH(rsqrtf)
#undef ROSARCH_MATH
template <typename T> T __ldg(const T*);
#define ROSARCH_REINTERPRET(to, name, from) to name(from);
ROSARCH_REINTERPRET(int, __float_as_int, float) ROSARCH_REINTERPRET(float, __int_as_float, int) ROSARCH_REINTERPRET(long long, __double_as_longlong, double)
ROSARCH_REINTERPRET(double, __longlong_as_double, long long)
#undef ROSARCH_REINTERPRET
#endif
