//! A thread that cancels a statement which takes too long, and ends the backend when cancel does not help.

use std::process::Command;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use postgres::{Config, NoTls};

/// A statement that does not end this long after its cancel hangs.
const HANG: Duration = Duration::from_secs(5);

#[derive(Default)]
struct Job {
    number: u64,
    pid: i32,
    running: bool,
    began: Option<Instant>,
    cancelled: Option<Instant>,
    hung: bool,
    stop: bool,
}

/// What became of a statement.
pub struct Watched {
    pub cancelled: Option<Duration>,
    pub hung: bool,
}

pub struct Watch {
    job: Arc<Mutex<Job>>,
}

impl Watch {
    pub fn new(admin: Config, cancel_after: Duration) -> Self {
        let job = Arc::new(Mutex::new(Job::default()));
        let theirs = Arc::clone(&job);
        std::thread::spawn(move || watch(&theirs, &admin, cancel_after));
        Self { job }
    }

    pub fn begin(&self, pid: i32) {
        let mut job = self.job.lock().unwrap();
        let number = job.number + 1;
        *job = Job { number, pid, running: true, began: Some(Instant::now()), ..Job::default() };
    }

    pub fn end(&self) -> Watched {
        let mut job = self.job.lock().unwrap();
        job.running = false;
        Watched { cancelled: job.cancelled.map(|at| at.elapsed()), hung: job.hung }
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        self.job.lock().unwrap().stop = true;
    }
}

fn watch(shared: &Mutex<Job>, admin: &Config, cancel_after: Duration) {
    loop {
        std::thread::sleep(Duration::from_millis(20));
        let job = shared.lock().unwrap();
        if job.stop {
            return;
        }
        let (number, pid, since) = (job.number, job.pid, job.began.map_or(Duration::ZERO, |b| b.elapsed()));
        if !job.running || since < cancel_after {
            continue;
        }
        let cancelled = job.cancelled;
        drop(job);
        match cancelled {
            None => {
                // The clock starts when the signal was sent: the connection made for it is not the statement's delay.
                let sent = ask(admin, &format!("SELECT pg_cancel_backend({pid})"));
                let mut job = shared.lock().unwrap();
                if sent && job.number == number && job.running {
                    job.cancelled = Some(Instant::now());
                }
            }
            Some(at) if at.elapsed() > HANG => end_by_force(shared, admin, number, pid),
            Some(_) => {}
        }
    }
}

/// Terminate, and if that does not help either, kill: the run goes on after the server's recovery.
fn end_by_force(shared: &Mutex<Job>, admin: &Config, number: u64, pid: i32) {
    let still = |hung: bool| {
        let mut job = shared.lock().unwrap();
        let same = job.number == number && job.running;
        job.hung |= same && hung;
        same
    };
    if !still(true) {
        return;
    }
    ask(admin, &format!("SELECT pg_terminate_backend({pid})"));
    std::thread::sleep(Duration::from_secs(2));
    if still(true) {
        let _ = Command::new("kill").args(["-9", &pid.to_string()]).status();
        std::thread::sleep(Duration::from_secs(2));
    }
}

fn ask(admin: &Config, sql: &str) -> bool {
    admin.connect(NoTls).is_ok_and(|mut c| c.batch_execute(sql).is_ok())
}
