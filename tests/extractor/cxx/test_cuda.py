"""CUDA sources: kernels, what they call, and how they are launched."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from rosarch.extractor.cxx.includes import HeaderFinder
from rosarch.extractor.cxx.translation_unit import CompileUnit, build_prelude, extract_unit

SOURCE = """#include <ros/ros.h>
#include <cuda_runtime.h>

__constant__ float gains[3];

__host__ __device__ float scale(float x, float gain) { return x * gain; }

template <typename T>
__global__ void filter(const T* in, T* out, int n)
{
  __shared__ float part[16];
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n)
    part[threadIdx.x] = scale(in[i], gains[0]);
  __syncthreads();
  out[i] = part[threadIdx.x];
}

void run(ros::Publisher& pub, int n, cudaStream_t stream)
{
  float* in;
  float* out;
  if (cudaMalloc((void**)&in, n * sizeof(float)) != cudaSuccess)
    return;
  dim3 block(16), grid((n + 15) / 16);
  filter<float><<<grid, block, 0, stream>>>(in, out, n);
  pub.publish(n);
}
"""


def rows_of(folder: Path, text: str, name: str = "filter.cu", heal: bool = False) -> Mapping[str, set[tuple[str | int, ...]]]:
    path = folder / name
    path.write_text(text)
    prelude = folder / "prelude.pch"
    build_prelude(prelude)
    finder = HeaderFinder(folder, folder / "scratch", lambda _name: None)
    return extract_unit(CompileUnit(path), folder, finder, prelude, heal=heal)


def test_kernels_and_their_launch(tmp_path: Path) -> None:
    rows = rows_of(tmp_path, SOURCE)
    named = dict(rows["function_name"])
    holders = dict(rows["expr_function"])
    calls = {(named[holders[call]], named[function]) for call, function in rows["call_function"] if call in holders}
    assert ("filter", "scale") in calls
    assert ("run", "filter") in calls
    assert ("run", "ros::Publisher::publish") in calls
    assert not rows["expr_unknown"] and not [row for row in rows["call_unresolved"] if row[1] == "recovered"]


@pytest.mark.parametrize("header", ["cuda_runtime.h", "cuda_runtime_api.h", "cuda.h", "vector_types.h"])
def test_a_cxx_source_that_uses_the_runtime(tmp_path: Path, header: str) -> None:
    rows = rows_of(
        tmp_path,
        f"#include <{header}>\nvoid f(float3 p) {{ cudaStream_t s; cudaStreamCreate(&s); cudaMemcpy(&p.x, 0, 4, cudaMemcpyDeviceToHost); }}",
        "f.cpp",
    )
    assert {name for _, name in rows["call"]} == {"cudaStreamCreate", "cudaMemcpy"}
    assert not [row for row in rows["call_unresolved"] if row[1] == "recovered"]


def test_an_unknown_library_of_kernels_is_stood_in_for(tmp_path: Path) -> None:
    text = "#include <curand.h>\n__global__ void k(int n) { far::noise<float>(n); }\nvoid f(int n) { curandGenerator_t g; curandCreate(&g, n); k<<<1, n>>>(n); }"
    rows = rows_of(tmp_path, text, heal=True)
    assert {name for _, name in rows["call"]} >= {"noise", "curandCreate", "k"}
    assert not [row for row in rows["call_unresolved"] if row[1] == "recovered"]
