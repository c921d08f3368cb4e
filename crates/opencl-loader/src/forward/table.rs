//! Every OpenCL function that the bindings can refer to, one row each.
//!
//! A row is a kind, a name and the arguments. Only what the calling convention tells apart is written down: the
//! width of a number, or [`Pointer`] for all handles, pointers and callbacks. The kinds:
//!
//! | kind | returns | where the function is missing |
//! |---|---|---|
//! | `code` | an error code | that code says so |
//! | `release` | an error code | always success: nobody can act on a failure, and the bindings abort on it |
//! | `object` | a handle, and an error code through one more argument at the end | null and the code |
//! | `pointer` | a pointer | null |
//! | `nothing` | nothing | nothing happens |
//!
//! The caller of every one of these functions owes what the OpenCL standard asks; a forwarder adds no demand.

#![allow(non_snake_case)]

use super::{INVALID_OPERATION, Pointer, SUCCESS, Slot, known, missing, store};
use std::mem::transmute;
use std::ptr::null_mut;

macro_rules! forwarders {
    ($($kind:ident $name:ident ( $($argument:ident : $type:ty),* );)*) => {
        $(forwarder!($kind $name ( $($argument: $type),* ));)*

        /// The forwarders themselves, so that naming this one list names them all.
        pub(super) static OWN: [Own; [$(stringify!($name)),*].len()] = [$(Own($name as *const ())),*];
    };
}

/// The address of a function of this program.
pub(super) struct Own(#[allow(dead_code, reason = "kept for the linker alone")] *const ());

// SAFETY: the address of a function is a constant.
unsafe impl Sync for Own {}

macro_rules! forwarder {
    (code $name:ident ( $($argument:ident : $type:ty),* )) => {
        #[unsafe(no_mangle)]
        unsafe extern "system" fn $name($($argument: $type),*) -> i32 {
            match found!($name($($type),*) -> i32) {
                // SAFETY: the caller's promises are passed on unchanged.
                Some(function) => known(unsafe { function($($argument),*) }),
                None => missing(),
            }
        }
    };
    (release $name:ident ( $($argument:ident : $type:ty),* )) => {
        #[unsafe(no_mangle)]
        unsafe extern "system" fn $name($($argument: $type),*) -> i32 {
            if let Some(function) = found!($name($($type),*) -> i32) {
                // SAFETY: the caller's promises are passed on unchanged.
                unsafe { function($($argument),*) };
            }
            SUCCESS
        }
    };
    (object $name:ident ( $($argument:ident : $type:ty),* )) => {
        #[unsafe(no_mangle)]
        unsafe extern "system" fn $name($($argument: $type,)* code_out: *mut i32) -> Pointer {
            let (object, code) = match found!($name($($type,)* *mut i32) -> Pointer) {
                Some(function) => {
                    let mut code = SUCCESS;
                    // SAFETY: the caller's promises are passed on, and the code goes to a local variable.
                    let object = unsafe { function($($argument,)* &mut code) };
                    // A driver that makes nothing and calls it success is not believed.
                    let code = if object.is_null() && code == SUCCESS { INVALID_OPERATION } else { known(code) };
                    (object, code)
                }
                None => (null_mut(), missing()),
            };
            // SAFETY: the standard lets the caller pass null or a valid place here.
            unsafe { store(code_out, code) };
            object
        }
    };
    (pointer $name:ident ( $($argument:ident : $type:ty),* )) => {
        #[unsafe(no_mangle)]
        unsafe extern "system" fn $name($($argument: $type),*) -> Pointer {
            match found!($name($($type),*) -> Pointer) {
                // SAFETY: the caller's promises are passed on unchanged.
                Some(function) => unsafe { function($($argument),*) },
                None => null_mut(),
            }
        }
    };
    (nothing $name:ident ( $($argument:ident : $type:ty),* )) => {
        #[unsafe(no_mangle)]
        unsafe extern "system" fn $name($($argument: $type),*) {
            if let Some(function) = found!($name($($type),*) -> ()) {
                // SAFETY: the caller's promises are passed on unchanged.
                unsafe { function($($argument),*) };
            }
        }
    };
}

/// The real function of a name, if there is one.
macro_rules! found {
    ($name:ident($($type:ty),*) -> $result:ty) => {{
        type Function = unsafe extern "system" fn($($type),*) -> $result;
        static SLOT: Slot = Slot::new({
            const NAME: &str = concat!(stringify!($name), "\0");
            match std::ffi::CStr::from_bytes_with_nul(NAME.as_bytes()) {
                Ok(name) => name,
                Err(_) => unreachable!(),
            }
        });
        // SAFETY: the address is the one found under this very name, whose types the row restates.
        SLOT.address().map(|address| unsafe { transmute::<Pointer, Function>(address) })
    }};
}

forwarders! {
    // Platforms and devices.
    code clGetPlatformInfo(platform: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clGetDeviceIDs(platform: Pointer, device_type: u64, num_entries: u32, devices: Pointer, num_devices: Pointer);
    code clGetDeviceInfo(device: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clCreateSubDevices(
        in_device: Pointer, properties: Pointer, num_devices: u32, out_devices: Pointer, num_devices_ret: Pointer
    );
    code clRetainDevice(device: Pointer);
    release clReleaseDevice(device: Pointer);
    code clSetDefaultDeviceCommandQueue(context: Pointer, device: Pointer, queue: Pointer);
    code clGetDeviceAndHostTimer(device: Pointer, device_timestamp: Pointer, host_timestamp: Pointer);
    code clGetHostTimer(device: Pointer, host_timestamp: Pointer);

    // Contexts and queues.
    object clCreateContext(
        properties: Pointer, num_devices: u32, devices: Pointer, pfn_notify: Pointer, user_data: Pointer
    );
    object clCreateContextFromType(properties: Pointer, device_type: u64, pfn_notify: Pointer, user_data: Pointer);
    code clRetainContext(context: Pointer);
    release clReleaseContext(context: Pointer);
    code clGetContextInfo(context: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    object clCreateCommandQueue(context: Pointer, device: Pointer, properties: u64);
    object clCreateCommandQueueWithProperties(context: Pointer, device: Pointer, properties: Pointer);
    code clRetainCommandQueue(queue: Pointer);
    release clReleaseCommandQueue(queue: Pointer);
    code clGetCommandQueueInfo(queue: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clFlush(queue: Pointer);
    code clFinish(queue: Pointer);

    // Memory.
    object clCreateBuffer(context: Pointer, flags: u64, size: usize, host_ptr: Pointer);
    object clCreateSubBuffer(buffer: Pointer, flags: u64, buffer_create_type: u32, buffer_create_info: Pointer);
    object clCreateImage2D(
        context: Pointer, flags: u64, image_format: Pointer, image_width: usize, image_depth: usize,
        image_slc_pitch: usize, host_ptr: Pointer
    );
    object clCreateImage3D(
        context: Pointer, flags: u64, image_format: Pointer, image_width: usize, image_height: usize,
        image_depth: usize, image_row_pitch: usize, image_slc_pitch: usize, host_ptr: Pointer
    );
    object clCreateImage(context: Pointer, flags: u64, image_format: Pointer, image_desc: Pointer, host_ptr: Pointer);
    object clCreatePipe(
        context: Pointer, flags: u64, pipe_packet_size: u32, pipe_max_packets: u32, properties: Pointer
    );
    code clRetainMemObject(memobj: Pointer);
    release clReleaseMemObject(memobj: Pointer);
    code clGetSupportedImageFormats(
        context: Pointer, flags: u64, image_type: u32, num_entries: u32, image_formats: Pointer,
        num_image_formats: Pointer
    );
    code clGetMemObjectInfo(memobj: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clGetImageInfo(image: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clGetPipeInfo(pipe: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clSetMemObjectDestructorCallback(memobj: Pointer, pfn_notify: Pointer, user_data: Pointer);

    // Shared virtual memory.
    pointer clSVMAlloc(context: Pointer, flags: u64, size: usize, alignment: u32);
    nothing clSVMFree(context: Pointer, svm_pointer: Pointer);
    code clSetKernelArgSVMPointer(kernel: Pointer, arg_index: u32, arg_value: Pointer);

    // Samplers.
    object clCreateSampler(context: Pointer, normalize_coords: u32, addressing_mode: u32, filter_mode: u32);
    object clCreateSamplerWithProperties(context: Pointer, normalized_coords: Pointer);
    code clRetainSampler(sampler: Pointer);
    release clReleaseSampler(sampler: Pointer);
    code clGetSamplerInfo(sampler: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);

    // Programs.
    object clCreateProgramWithSource(context: Pointer, count: u32, strings: Pointer, lengths: Pointer);
    object clCreateProgramWithBinary(
        context: Pointer, num_devices: u32, device_list: Pointer, lengths: Pointer, binaries: Pointer,
        binary_status: Pointer
    );
    object clCreateProgramWithBuiltInKernels(
        context: Pointer, num_devices: u32, device_list: Pointer, kernel_names: Pointer
    );
    object clCreateProgramWithIL(context: Pointer, il: Pointer, length: usize);
    code clRetainProgram(program: Pointer);
    release clReleaseProgram(program: Pointer);
    code clBuildProgram(
        program: Pointer, num_devices: u32, device_list: Pointer, options: Pointer, pfn_notify: Pointer,
        user_data: Pointer
    );
    code clUnloadCompiler();
    code clCompileProgram(
        program: Pointer, num_devices: u32, device_list: Pointer, options: Pointer, num_input_headers: u32,
        input_headers: Pointer, header_include_names: Pointer, pfn_notify: Pointer, user_data: Pointer
    );
    object clLinkProgram(
        context: Pointer, num_devices: u32, device_list: Pointer, options: Pointer, num_input_programs: u32,
        input_programs: Pointer, pfn_notify: Pointer, user_data: Pointer
    );
    code clGetProgramInfo(program: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clGetProgramBuildInfo(
        program: Pointer, device: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer
    );
    code clCreateKernelsInProgram(program: Pointer, num_kernels: u32, kernels: Pointer, num_kernels_ret: Pointer);

    // Kernels.
    object clCreateKernel(program: Pointer, kernel_name: Pointer);
    object clCloneKernel(source_kernel: Pointer);
    code clRetainKernel(kernel: Pointer);
    release clReleaseKernel(kernel: Pointer);
    code clSetKernelArg(kernel: Pointer, arg_index: u32, arg_size: usize, arg_value: Pointer);
    code clSetKernelExecInfo(kernel: Pointer, what: u32, size: usize, value: Pointer);
    code clGetKernelInfo(kernel: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clGetKernelArgInfo(kernel: Pointer, arg_indx: u32, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    code clGetKernelWorkGroupInfo(
        kernel: Pointer, device: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer
    );
    code clGetKernelSubGroupInfo(
        kernel: Pointer, device: Pointer, what: u32, input_value_size: usize, input_value: Pointer, size: usize,
        value: Pointer, size_ret: Pointer
    );

    // Events.
    code clWaitForEvents(num_events: u32, event_list: Pointer);
    code clGetEventInfo(event: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    object clCreateUserEvent(context: Pointer);
    code clRetainEvent(event: Pointer);
    release clReleaseEvent(event: Pointer);
    code clSetUserEventStatus(event: Pointer, execution_status: i32);
    code clSetEventCallback(event: Pointer, command_exec_callback_type: i32, pfn_notify: Pointer, user_data: Pointer);
    code clGetEventProfilingInfo(event: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);

    // Commands.
    code clEnqueueReadBuffer(
        queue: Pointer, buffer: Pointer, blocking_read: u32, offset: usize, cb: usize, ptr: Pointer, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    code clEnqueueReadBufferRect(
        queue: Pointer, buffer: Pointer, blocking_read: u32, buffer_origin: Pointer, host_origin: Pointer,
        region: Pointer, buffer_row_pitch: usize, buffer_slc_pitch: usize, host_row_pitch: usize,
        host_slc_pitch: usize, ptr: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueWriteBuffer(
        queue: Pointer, buffer: Pointer, blocking_write: u32, offset: usize, cb: usize, ptr: Pointer, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    code clEnqueueWriteBufferRect(
        queue: Pointer, buffer: Pointer, blocking_write: u32, buffer_origin: Pointer, host_origin: Pointer,
        region: Pointer, buffer_row_pitch: usize, buffer_slc_pitch: usize, host_row_pitch: usize,
        host_slc_pitch: usize, ptr: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueFillBuffer(
        queue: Pointer, buffer: Pointer, pattern: Pointer, pattern_size: usize, offset: usize, size: usize,
        waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueCopyBuffer(
        queue: Pointer, src_buffer: Pointer, dst_buffer: Pointer, src_offset: usize, dst_offset: usize, cb: usize,
        waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueCopyBufferRect(
        queue: Pointer, src_buffer: Pointer, dst_buffer: Pointer, src_origin: Pointer, dst_origin: Pointer,
        region: Pointer, src_row_pitch: usize, src_slc_pitch: usize, dst_row_pitch: usize, dst_slc_pitch: usize,
        waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueReadImage(
        queue: Pointer, image: Pointer, blocking_read: u32, origin: Pointer, region: Pointer, row_pitch: usize,
        slc_pitch: usize, ptr: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueWriteImage(
        queue: Pointer, image: Pointer, blocking_write: u32, origin: Pointer, region: Pointer,
        input_row_pitch: usize, input_slc_pitch: usize, ptr: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueFillImage(
        queue: Pointer, image: Pointer, fill_color: Pointer, origin: Pointer, region: Pointer, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    code clEnqueueCopyImage(
        queue: Pointer, src_image: Pointer, dst_image: Pointer, src_origin: Pointer, dst_origin: Pointer,
        region: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueCopyImageToBuffer(
        queue: Pointer, src_image: Pointer, dst_buffer: Pointer, src_origin: Pointer, region: Pointer,
        dst_offset: usize, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueCopyBufferToImage(
        queue: Pointer, src_buffer: Pointer, dst_image: Pointer, src_offset: usize, dst_origin: Pointer,
        region: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    object clEnqueueMapBuffer(
        queue: Pointer, buffer: Pointer, blocking_map: u32, map_flags: u64, offset: usize, size: usize, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    object clEnqueueMapImage(
        queue: Pointer, image: Pointer, blocking_map: u32, map_flags: u64, origin: Pointer, region: Pointer,
        image_row_pitch: Pointer, image_slc_pitch: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueUnmapMemObject(
        queue: Pointer, memobj: Pointer, mapped_ptr: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueMigrateMemObjects(
        queue: Pointer, num_mem_objects: u32, mem_objects: Pointer, flags: u64, waits: u32, wait_list: Pointer,
        event: Pointer
    );
    code clEnqueueNDRangeKernel(
        queue: Pointer, kernel: Pointer, work_dim: u32, global_work_offset: Pointer, global_work_dims: Pointer,
        local_work_dims: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueTask(queue: Pointer, kernel: Pointer, waits: u32, wait_list: Pointer, event: Pointer);
    code clEnqueueNativeKernel(
        queue: Pointer, user_func: Pointer, args: Pointer, cb_args: usize, num_mem_objects: u32, mem_list: Pointer,
        args_mem_loc: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueMarker(queue: Pointer, event: Pointer);
    code clEnqueueMarkerWithWaitList(queue: Pointer, waits: u32, wait_list: Pointer, event: Pointer);
    code clEnqueueWaitForEvents(queue: Pointer, num_events: u32, event_list: Pointer);
    code clEnqueueBarrierWithWaitList(queue: Pointer, waits: u32, wait_list: Pointer, event: Pointer);
    code clEnqueueSVMFree(
        queue: Pointer, num_svm_pointers: u32, svm_pointers: Pointer, pfn_free_func: Pointer, user_data: Pointer,
        waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueSVMMemcpy(
        queue: Pointer, blocking_copy: u32, dst_ptr: Pointer, src_ptr: Pointer, size: usize, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    code clEnqueueSVMMemFill(
        queue: Pointer, svm_ptr: Pointer, pattern: Pointer, pattern_size: usize, size: usize, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    code clEnqueueSVMMap(
        queue: Pointer, blocking_map: u32, flags: u64, svm_ptr: Pointer, size: usize, waits: u32, wait_list: Pointer,
        event: Pointer
    );
    code clEnqueueSVMUnmap(queue: Pointer, svm_ptr: Pointer, waits: u32, wait_list: Pointer, event: Pointer);
    code clEnqueueSVMMigrateMem(
        queue: Pointer, num_svm_pointers: u32, svm_pointers: Pointer, sizes: Pointer, flags: u64, waits: u32,
        wait_list: Pointer, event: Pointer
    );
    code clEnqueueBarrier(queue: Pointer);

    // Extensions.
    pointer clGetExtensionFunctionAddress(func_name: Pointer);
    pointer clGetExtensionFunctionAddressForPlatform(platform: Pointer, func_name: Pointer);

    // Sharing with OpenGL.
    object clCreateFromGLBuffer(context: Pointer, flags: u64, bufobj: u32);
    object clCreateFromGLTexture(context: Pointer, flags: u64, texture_target: u32, miplevel: i32, texture: u32);
    code clGetGLObjectInfo(memobj: Pointer, gl_object_type: Pointer, gl_object_name: Pointer);
    code clGetGLTextureInfo(memobj: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    object clCreateFromGLRenderbuffer(context: Pointer, flags: u64, renderbuffer: u32);
    code clEnqueueAcquireGLObjects(
        queue: Pointer, num_objects: u32, mem_objects: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clEnqueueReleaseGLObjects(
        queue: Pointer, num_objects: u32, mem_objects: Pointer, waits: u32, wait_list: Pointer, event: Pointer
    );
    code clGetGLContextInfoKHR(properties: Pointer, what: u32, size: usize, value: Pointer, size_ret: Pointer);
    object clCreateFromGLTexture2D(context: Pointer, flags: u64, texture_target: u32, miplevel: i32, texture: u32);
    object clCreateFromGLTexture3D(context: Pointer, flags: u64, texture_target: u32, miplevel: i32, texture: u32);
}
