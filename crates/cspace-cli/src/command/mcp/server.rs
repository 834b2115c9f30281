//! The protocol, on standard input and output.

use std::sync::Arc;

use rmcp::model::{
    CallToolRequestParams, CallToolResponse, CallToolResult, ContentBlock, Implementation,
    ListToolsResult, PaginatedRequestParams, ServerCapabilities, ServerConfig, Tool,
};
use rmcp::service::RequestContext;
use rmcp::transport::stdio;
use rmcp::{ErrorData, RoleServer, ServerHandler, ServiceExt};

use super::call::{Said, call};
use super::folder::Folder;
use super::host::Caller;
use super::tools::tools;
use crate::failure::Failure;

const INSTRUCTIONS: &str = "\
Exact answers about planar mechanical parts of lines and arcs: does it fit, what touches, how far does it move, does it clear over its whole \
range, can it be assembled. Write a model as text (tool `reference` says how; `model_info` and `draw` show whether it is what you mean), then \
ask. `no-path` is proved, and `clear` down to the gap `least`. Lengths are in the model's unit, angles in radians.";

#[derive(Debug, Clone)]
struct Server {
    folder: Arc<Folder>,
}

impl ServerHandler for Server {
    fn get_info(&self) -> ServerConfig {
        let capabilities = ServerCapabilities::builder().enable_tools().build();
        let own = Implementation::new("cspace", env!("CARGO_PKG_VERSION"));
        ServerConfig::new(capabilities)
            .with_server_info(own)
            .with_instructions(INSTRUCTIONS)
    }

    async fn list_tools(
        &self,
        _: Option<PaginatedRequestParams>,
        _: RequestContext<RoleServer>,
    ) -> Result<ListToolsResult, ErrorData> {
        let listed = tools().iter();
        let listed =
            listed.map(|tool| Tool::new(tool.name, &*tool.about, Arc::new(tool.takes.clone())));
        Ok(ListToolsResult::with_all_items(listed.collect()))
    }

    async fn call_tool(
        &self,
        request: CallToolRequestParams,
        context: RequestContext<RoleServer>,
    ) -> Result<CallToolResponse, ErrorData> {
        let folder = Arc::clone(&self.folder);
        // The answer is computed beside the thread that listens: a call may be cancelled.
        let answered = tokio::task::spawn_blocking(move || {
            let host = Caller::new(context.ct);
            let arguments = request.arguments.unwrap_or_default();
            call(&request.name, arguments, &folder, &host)
        });
        let answered = answered.await;
        let answered = answered.map_err(|e| ErrorData::internal_error(e.to_string(), None))?;
        let blocks = |said: Vec<Said>| said.into_iter().map(block).collect();
        Ok(match answered {
            Ok(said) => CallToolResult::success(blocks(said)),
            Err(said) => CallToolResult::error(blocks(said)),
        }
        .into())
    }
}

fn block(said: Said) -> ContentBlock {
    match said {
        Said::Text(text) => ContentBlock::text(text),
        Said::Picture(png) => ContentBlock::image(png, "image/png"),
    }
}

/// Answers until the assistant closes standard input.
pub(super) fn run(folder: Folder) -> Result<(), Failure> {
    let failed = |e: &dyn core::fmt::Display| Failure::new(format_args!("the server ended: {e}"));
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(1)
        .enable_all()
        .build()
        .map_err(|e| failed(&e))?;
    let folder = Arc::new(folder);
    runtime.block_on(async {
        let running = Server { folder }.serve(stdio()).await;
        let running = running.map_err(|e| failed(&e))?;
        running.waiting().await.map_err(|e| failed(&e))?;
        Ok(())
    })
}
