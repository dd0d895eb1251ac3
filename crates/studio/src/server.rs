//! The server: one address, a page and its questions.

use crate::asking::{self, Desk, refused};
use crate::assets::asset;
use crate::error::StudioError;
use crate::folder::Folder;
use crate::gate::{Gate, random_token};
use crate::watch::events;
use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::{DefaultBodyLimit, Request, State};
use axum::http::{HeaderValue, header};
use axum::middleware::{Next, from_fn_with_state, map_response};
use axum::response::Response;
use axum::routing::get;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use lanchester_answers::{Files, Problem, Status, Studio};
use std::convert::Infallible;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::{Arc, LazyLock};
use std::time::{Duration, Instant};
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

/// A question may be this long [bytes]: an engine file of the largest kind, some others beside it to compare with, and what is asked.
const LONGEST_QUESTION: usize = 24 << 20;

/// Most connections at a time: a window has half a dozen.
const MOST_CONNECTIONS: usize = 256;

/// A longer head of a question is refused [bytes]: that of a browser has one or two thousand. The server reads by up to half of it at a time
/// and looks at the length between, so that heads of half this length are taken for certain.
const LONGEST_HEAD: usize = 64 << 10;

/// Who asks has so long for the head of a question, and as long again for its body: both come from this machine.
const PATIENCE: Duration = Duration::from_secs(20);

/// How the studio is started.
#[derive(Debug, Clone)]
pub struct Options {
    /// An engine file to open, or a folder; the file's folder is the only one that the studio reads and writes.
    pub path: PathBuf,
    /// The port; `None`: a free one.
    pub port: Option<u16>,
    /// Whether it listens at all interfaces, for a port that is forwarded; else at the loopback address alone. Hosts and origins are those of
    /// the loopback address in both cases.
    pub all_interfaces: bool,
    /// The token of the address; `None`: a random one.
    pub token: Option<String>,
    /// Name, version and commit of the program, for reports.
    pub program: String,
}

/// Serves until the process is asked to stop (Ctrl-C); `announce` gets the address once it answers.
///
/// # Errors
/// [`StudioError`] where the file or its folder cannot be used or the address is taken.
pub fn serve(options: &Options, announce: impl FnOnce(&str)) -> Result<(), StudioError> {
    let system = |error: &dyn std::fmt::Display| StudioError::System(error.to_string());
    if !options.path.exists() {
        return Err(StudioError::Missing { path: options.path.clone() });
    }
    let is_folder = options.path.is_dir();
    let folder_path = if is_folder { Some(options.path.as_path()) } else { options.path.parent() };
    let folder_path = folder_path.unwrap_or_else(|| "".as_ref()).to_path_buf();
    let folder =
        Folder::new(&folder_path).map_err(|error| StudioError::Folder { folder: folder_path, error })?;
    let open = match is_folder {
        true => None,
        false => {
            let name = options.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let told = |problem: Problem| {
                StudioError::File(format!("{}\nhint: {}", problem.message, problem.hint.unwrap_or_default()))
            };
            Some(folder.open(&name).map_err(told)?.name)
        }
    };
    let token = match &options.token {
        Some(token) => token.clone(),
        None => random_token().map_err(|error| system(&error))?,
    };
    let processors = std::thread::available_parallelism().map_or(2, usize::from);
    let studio = Studio::new(options.program.clone(), Box::new(folder), since_start);
    if let Some(name) = open {
        studio.opened(&name);
    }
    let desk = Desk::new(studio, processors);
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build();
    let runtime = runtime.map_err(|error| system(&error))?;
    let ended = runtime.block_on(async {
        let interface = if options.all_interfaces { Ipv4Addr::UNSPECIFIED } else { Ipv4Addr::LOCALHOST };
        let address = SocketAddr::from((interface, options.port.unwrap_or(0)));
        let listener = TcpListener::bind(address).await.map_err(|error| match error.kind() {
            std::io::ErrorKind::AddrInUse => StudioError::Taken { port: address.port() },
            _ => StudioError::Listen { address, error },
        })?;
        let port = listener.local_addr().map_err(|error| system(&error))?.port();
        let app = router(Arc::new(desk), Gate::new(token.clone(), port));
        announce(&format!("http://{}:{port}/?token={token}", Ipv4Addr::LOCALHOST));
        tokio::select! {
            never = answer(listener, app) => match never {},
            // Streams of events never end by themselves: nobody waits for them.
            _ = tokio::signal::ctrl_c() => Ok(()),
            () = terminated() => Ok(()),
        }
    });
    // Nor does anybody wait for an answer that is still computed.
    runtime.shutdown_background();
    ended
}

/// Takes connections for ever, so many at a time, and none that is silent for long.
async fn answer(listener: TcpListener, app: Router) -> Infallible {
    let room = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    loop {
        let place = room.clone().acquire_owned().await;
        let Ok((stream, _)) = listener.accept().await else {
            // As a rule too many open files: some will be closed.
            tokio::time::sleep(Duration::from_millis(50)).await;
            continue;
        };
        let service = TowerToHyperService::new(app.clone());
        tokio::spawn(async move {
            let _place = place;
            let mut http = http1::Builder::new();
            http.timer(TokioTimer::new()).header_read_timeout(PATIENCE).max_buf_size(LONGEST_HEAD / 2);
            // Who breaks off has gone: there is nobody to tell.
            let _ = http.serve_connection(TokioIo::new(stream), service).await;
        });
    }
}

/// Until the system asks the process to end.
async fn terminated() {
    #[cfg(unix)]
    if let Ok(mut signal) = tokio::signal::unix::signal(tokio::signal::unix::SignalKind::terminate()) {
        signal.recv().await;
        return;
    }
    std::future::pending().await
}

/// Time since the first call.
fn since_start() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

fn router(desk: Arc<Desk>, gate: Gate) -> Router {
    let watched = desk.clone();
    let questions = asking::router(desk).route("/api/events", get(move || async { events(watched) }));
    let questions = questions
        .layer(DefaultBodyLimit::max(LONGEST_QUESTION))
        .layer(from_fn_with_state(gate.clone(), with_token));
    let all = Router::new().merge(questions).fallback(asset).layer(from_fn_with_state(gate, in_place));
    all.layer(map_response(guarded))
}

/// No answer is kept by a browser or taken for something else than it says; a newer program brings a newer page at the same address.
async fn guarded(mut response: Response) -> Response {
    let headers = response.headers_mut();
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
    headers.insert(header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff"));
    headers.insert(header::REFERRER_POLICY, HeaderValue::from_static("no-referrer"));
    response
}

async fn with_token(State(gate): State<Gate>, request: Request, next: Next) -> Response {
    if let Err(problem) = gate.check_token(request.headers(), request.uri()) {
        return refused(problem);
    }
    let (parts, body) = request.into_parts();
    match tokio::time::timeout(PATIENCE, to_bytes(body, LONGEST_QUESTION)).await {
        Ok(Ok(bytes)) => next.run(Request::from_parts(parts, Body::from(bytes))).await,
        Ok(Err(_)) => refused(Problem::new(
            Status::TooLong,
            format!("a question has at most {} MiB, got a longer one", LONGEST_QUESTION >> 20),
            "ask about fewer files at a time",
        )),
        Err(_) => refused(Problem::new(
            Status::Late,
            format!("a question comes whole within {} s, got a part of it", PATIENCE.as_secs()),
            "ask again",
        )),
    }
}

async fn in_place(State(gate): State<Gate>, request: Request, next: Next) -> Response {
    match gate.check_place(request.headers(), request.uri()) {
        Ok(()) => next.run(request).await,
        Err(problem) => refused(problem),
    }
}
